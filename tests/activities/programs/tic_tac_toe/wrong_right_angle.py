robot.move_forward(1)
robot.turn(-90)
for _ in range(2):
    robot.move_forward(1.41)
