for _ in range(4):
    robot.move_forward(1.0)
    robot.turn(90)
