robot.move_forward(0.75)
robot.turn(90)
for _ in range(2):
    robot.arc(0.75, -180)
    robot.arc(0.75, -180)
robot.turn(-90)
