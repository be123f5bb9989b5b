if robot.gesture_result == "B":
    robot.move_forward(1)
robot.classify_gestures(timeout=10)
