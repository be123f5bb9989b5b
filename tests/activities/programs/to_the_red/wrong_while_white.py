while robot.floor == "white":
    robot.move_forward(0.1)
