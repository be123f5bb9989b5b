robot.pen(down=True)
for _ in range(5):
    robot.move_forward(2)
    robot.turn(36)
