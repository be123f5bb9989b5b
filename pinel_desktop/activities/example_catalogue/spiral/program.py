robot.pen(down=True)
for i in steps(1, 16):
    robot.move_forward(i * 0.2)
    robot.turn(90)
