lados = robot.ask("Quantos lados?")
robot.pen(down=True)
for _ in range(lados - 1):
    robot.move_forward(1)
    robot.turn(360 / lados)
