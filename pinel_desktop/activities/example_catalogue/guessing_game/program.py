segredo = random_int(1, 5)
palpite = 0
while not palpite == segredo:
    palpite = robot.ask("De 1 a 5, qual é o meu número?")
    if palpite < segredo:
        robot.move_forward(0.5)
    elif palpite > segredo:
        robot.move_backward(0.5)
robot.turn(360)
