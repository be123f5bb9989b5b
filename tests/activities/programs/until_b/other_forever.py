while True:
    robot.classify_gestures(timeout=10)
    if robot.gesture_result == "B":
        break
robot.move_forward(1)
