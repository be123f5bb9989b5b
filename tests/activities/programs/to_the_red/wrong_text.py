while not robot.floor == "vermelho":
    robot.move_forward(0.1)
