"""out of the maze with the right hand on the wall"""

while robot.cell != "meta":
    if robot.distance("right") > 0.4:
        robot.turn(-90)
        robot.move_forward(1.0)
    elif robot.distance("front") > 0.4:
        robot.move_forward(1.0)
    else:
        robot.turn(90)
robot.say(robot.cell)
