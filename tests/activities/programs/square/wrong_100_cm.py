for _ in range(4):
    robot.move_forward(100)
    robot.turn(90)
