robot.classify_gestures(timeout=10)
if robot.gesture_result == "B":
    robot.move_forward(2)
    robot.move_backward(2)
robot.classify_gestures(timeout=10)
if robot.gesture_result == "A":
    for _ in range(3):
        robot.move_forward(1)
        robot.turn(120)
