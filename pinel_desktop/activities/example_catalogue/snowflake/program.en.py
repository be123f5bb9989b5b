robot.pen(down=True)
for _ in range(3):
    side(2.4, 2)
    robot.turn(-120)


def side(t, n):
    if n == 0:
        robot.move_forward(t)
    else:
        side(t / 3, n - 1)
        robot.turn(60)
        side(t / 3, n - 1)
        robot.turn(-120)
        side(t / 3, n - 1)
        robot.turn(60)
        side(t / 3, n - 1)
