while not robot.time > 30:
    if robot.distance("front") < 0.8:
        robot.move_backward(0.4)
        robot.turn(120)
    else:
        robot.move_forward(0.2)
