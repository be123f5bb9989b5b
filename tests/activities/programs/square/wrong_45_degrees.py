for _ in range(4):
    robot.move_forward(1)
    robot.turn(45)
