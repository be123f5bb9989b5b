for _ in range(4):
    robot.move_backward(1)
    robot.turn(90)
