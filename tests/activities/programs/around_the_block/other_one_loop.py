n = 0
while n < 4:
    if robot.distance("left") > 1:
        robot.turn(90)
        robot.move_forward(0.8)
        n += 1
    else:
        robot.move_forward(0.1)
