lados = robot.ask("Quantos lados?")
robot.pen(down=True)
for _ in range(lados):
    robot.turn(360 / lados)
    robot.move_backward(1)
