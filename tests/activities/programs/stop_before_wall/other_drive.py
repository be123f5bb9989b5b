robot.drive(0.3, 0)
robot.wait_until(robot.distance("front") < 0.5)
robot.stop()
