secreto = random_int(1, 5)
intento = 0
while not intento == secreto:
    intento = robot.ask("De 1 a 5, ¿cuál es mi número?")
    if intento < secreto:
        robot.move_forward(0.5)
    elif intento > secreto:
        robot.move_backward(0.5)
robot.turn(360)
