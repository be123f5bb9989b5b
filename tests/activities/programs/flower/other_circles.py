robot.pen(down=True)
for _ in range(8):
    robot.arc(0.5, 360)
    robot.turn(45)
