robot.pen(down=True)
for _ in range(3):
    lado(2.4, 2)
    robot.turn(-120)


def lado(t, n):
    if n == 0:
        robot.move_forward(t)
    else:
        lado(t / 3, n - 1)
        robot.turn(60)
        lado(t / 3, n - 1)
        robot.turn(-120)
        lado(t / 3, n - 1)
        robot.turn(60)
        lado(t / 3, n - 1)
