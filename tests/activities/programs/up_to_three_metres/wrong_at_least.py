metros = robot.ask("Quantos metros?")
if metros >= 3:
    robot.say("longe demais")
else:
    robot.move_forward(metros)
