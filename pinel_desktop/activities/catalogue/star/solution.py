robot.pen(down=True, color="yellow")
for _ in range(5):
    robot.move_forward(2.0)
    robot.turn(144)
