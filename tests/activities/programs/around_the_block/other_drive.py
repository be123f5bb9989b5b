for _ in range(4):
    robot.drive(0.3, 0)
    robot.wait_until(robot.distance("left") > 1)
    robot.stop()
    robot.turn(90)
    robot.move_forward(0.8)
