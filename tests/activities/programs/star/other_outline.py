robot.pen(down=True)
for _ in range(5):
    robot.move_forward(0.8)
    robot.turn(-72)
    robot.move_forward(0.8)
    robot.turn(144)
