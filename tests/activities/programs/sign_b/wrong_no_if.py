robot.classify_gestures(timeout=10)
robot.move_forward(1)
