if robot.number_shown >= 0:
    robot.move_forward(robot.number_shown)
robot.read_number(timeout=10)
