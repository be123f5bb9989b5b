metros = robot.ask("Quantos metros?")
if metros > 3:
    robot.say("longe demais")
if metros < 4:
    robot.move_forward(metros)
