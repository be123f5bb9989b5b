robot.go_to(7, 0, avoid=True)
