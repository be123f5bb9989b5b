robot.pen(down=True)
for _ in range(6):
    for _ in range(4):
        robot.move_forward(0.8)
        robot.turn(90)
    robot.turn(60)
