robot.go_to(3, 0)
robot.go_to(3, 3)
robot.go_to(6, 3)
