metros = robot.ask("Quantos metros?")
if metros <= 3:
    robot.move_forward(metros)
else:
    robot.say("Longe demais!")
