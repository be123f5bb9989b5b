"""else and elif"""

robot.classify_gestures(timeout=5)
if robot.gesture_result == "A":
    robot.move_forward(1.0)
elif robot.gesture_result == "B" or robot.gesture_result == "C":
    robot.turn(90)
else:
    robot.move_forward(2.0)
