while not robot.gesture_result != "B":
    robot.classify_gestures(timeout=10)
robot.move_forward(1)
