while True:
    if robot.floor == "red":
        break
    robot.move_forward(0.1)
