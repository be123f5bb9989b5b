robot.classify_gestures(timeout=10)
if robot.gesture_result == "A":
    robot.go_to(1.0, 0.0)
    robot.mark("X")
elif robot.gesture_result == "E":
    robot.go_to(2.0, -1.0)
    robot.mark("X")
elif robot.gesture_result == "L":
    robot.go_to(3.0, -2.0)
    robot.mark("X")
