lados = robot.ask("Quantos lados?")
robot.pen(down=True)
for _ in range(lados):
    robot.move_forward(1)
    robot.turn(180 * (lados - 2) / lados)
