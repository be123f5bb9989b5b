robot.move_forward(robot.number_shown)
robot.read_number(timeout=10)
