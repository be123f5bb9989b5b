robot.classify_gestures(timeout=10)
if robot.gesture_result == "A":
    robot.go_to(1, 0)
elif robot.gesture_result == "E":
    robot.go_to(2, -1)
elif robot.gesture_result == "L":
    robot.go_to(3, -2)
robot.mark("X")
