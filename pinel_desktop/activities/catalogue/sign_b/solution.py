robot.classify_gestures(timeout=10)
if robot.gesture_result == "B":
    robot.move_forward(1.0)
