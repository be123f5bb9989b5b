for _ in range(4):
    if not robot.distance("left") > 1:
        robot.move_forward(0.1)
    robot.turn(90)
    robot.move_forward(0.8)
