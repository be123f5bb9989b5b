for _ in range(3):
    robot.pen(down=True)
    robot.move_backward(0.5)
    robot.pen(down=False)
    robot.move_backward(0.5)
