robot.move_forward(0.5)
for _ in range(3):
    robot.turn(-90)
    robot.move_forward(1)
robot.turn(-90)
robot.move_forward(0.5)
