robot.pen(down=True)
for _ in range(36):
    robot.move_forward(0.13)
    robot.turn(10)
for _ in range(36):
    robot.move_forward(0.13)
    robot.turn(-10)
