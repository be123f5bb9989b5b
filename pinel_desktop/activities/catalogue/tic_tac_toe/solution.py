robot.move_forward(1.0)
robot.turn(-45)
for _ in range(2):
    robot.move_forward(1.41)
