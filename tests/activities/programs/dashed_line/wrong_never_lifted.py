robot.pen(down=True)
for _ in range(3):
    robot.move_forward(0.5)
    robot.move_forward(0.5)
