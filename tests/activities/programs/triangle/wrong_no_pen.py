for _ in range(3):
    robot.move_forward(1.5)
    robot.turn(120)
