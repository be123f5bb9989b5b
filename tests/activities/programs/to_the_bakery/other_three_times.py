for _ in range(3):
    robot.move_forward(1)
