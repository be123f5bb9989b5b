robot.read_number(timeout=10)
if robot.number_shown > 0:
    for _ in range(robot.number_shown):
        robot.move_forward(1)
