robot.turn(90)
robot.pen(down=True)
robot.move_forward(2)
robot.turn(-90)
for _ in range(2):
    robot.arc(0.5, -180)
    robot.turn(180)
