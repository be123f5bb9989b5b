robot.pen(down=True)
for _ in range(4):
    robot.turn(90)
    robot.move_forward(0.5)
    robot.turn(-90)
    robot.move_forward(0.5)
