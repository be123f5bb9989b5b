metros = robot.ask("Quantos metros?")
if metros > 3:
    robot.say("longe demais")
    metros = 0
robot.move_forward(metros)
