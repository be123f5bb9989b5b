robot.read_number(timeout=10)
robot.move_forward(robot.number_shown)
