robot.classify_gestures(timeout=10)
if robot.gesture_result == "B":
    for _ in range(4):
        robot.move_forward(1)
        robot.turn(-90)
    robot.classify_gestures(timeout=10)
    if robot.gesture_result == "A":
        for _ in range(3):
            robot.move_forward(1)
            robot.turn(120)
