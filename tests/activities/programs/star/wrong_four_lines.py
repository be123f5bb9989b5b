robot.pen(down=True)
for _ in range(4):
    robot.move_forward(2)
    robot.turn(144)
