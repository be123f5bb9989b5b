while not robot.x > 5.5:
    robot.move_forward(0.1)
