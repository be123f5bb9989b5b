while not robot.distance("front") < 0.5:
    robot.move_forward(0.1)
