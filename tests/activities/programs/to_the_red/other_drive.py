robot.drive(0.3, 0)
robot.wait_until(robot.floor == "red")
robot.stop()
