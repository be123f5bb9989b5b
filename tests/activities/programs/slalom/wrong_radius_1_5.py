robot.move_forward(0.75)
robot.turn(90)
for _ in range(2):
    robot.arc(1.5, -180)
    robot.arc(1.5, 180)
robot.arc(1.5, -180)
