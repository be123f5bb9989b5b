while not robot.floor == "red":
    if robot.distance("right") > 0.5:
        robot.turn(90)
        robot.move_forward(1)
    elif robot.distance("front") > 0.5:
        robot.move_forward(1)
    else:
        robot.turn(90)
