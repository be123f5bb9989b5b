robot.pen(down=True)
for _ in range(12):
    for _ in range(3):
        robot.move_forward(0.8)
        robot.turn(120)
    robot.turn(30)
