while not robot.gesture_result == "B":
    robot.wait(1)
robot.move_forward(1)
