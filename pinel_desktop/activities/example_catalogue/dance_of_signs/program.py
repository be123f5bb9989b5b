while not robot.gesture_result == "B":
    robot.classify_gestures(timeout=10)
    if robot.gesture_result == "A":
        robot.turn(360)
    elif robot.gesture_result == "L":
        robot.arc(0.5, 180)
        robot.arc(0.5, -180)
