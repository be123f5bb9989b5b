robot.read_number(timeout=10)
if robot.number_shown >= 0:
    robot.move_forward(robot.number_shown)
