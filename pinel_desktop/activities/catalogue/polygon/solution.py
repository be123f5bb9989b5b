lados = robot.ask("Quantos lados?")
robot.pen(down=True)
for _ in range(lados):
    robot.move_forward(1.0)
    robot.turn(360 / lados)
