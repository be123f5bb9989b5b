while not robot.time > 90:
    if robot.distance("front") > 0.5:
        robot.move_forward(0.3)
    else:
        robot.turn(random_int(90, 200))
