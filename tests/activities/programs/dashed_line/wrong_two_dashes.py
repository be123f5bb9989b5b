for _ in range(2):
    robot.pen(down=True)
    robot.move_forward(0.5)
    robot.pen(down=False)
    robot.move_forward(0.5)
