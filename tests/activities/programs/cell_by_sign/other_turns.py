robot.classify_gestures(timeout=10)
if robot.gesture_result == "A":
    robot.move_forward(1)
    robot.mark("X")
elif robot.gesture_result == "E":
    robot.move_forward(1)
    robot.turn(-45)
    robot.move_forward(1.41)
    robot.mark("X")
elif robot.gesture_result == "L":
    robot.move_forward(1)
    robot.turn(-45)
    robot.move_forward(2.83)
    robot.mark("X")
