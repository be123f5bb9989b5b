robot.go_to(1, 0)
robot.go_to(3, -2)
