while not robot.floor == "red":
    robot.move_forward(0.1)
