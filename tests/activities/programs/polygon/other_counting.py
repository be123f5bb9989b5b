lados = robot.ask("Quantos lados?")
robot.pen(down=True)
n = 0
while n < lados:
    robot.move_forward(4 / lados)
    robot.turn(360 / lados)
    n += 1
