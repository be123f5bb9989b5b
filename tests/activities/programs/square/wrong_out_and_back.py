for _ in range(2):
    robot.move_forward(1)
    robot.turn(180)
    robot.move_forward(1)
    robot.turn(180)
