while not robot.floor == "red":
    robot.move_forward(1)
