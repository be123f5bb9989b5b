for _ in range(4):
    while not robot.distance("right") > 1:
        robot.move_forward(0.1)
    robot.turn(90)
    robot.move_forward(0.8)
