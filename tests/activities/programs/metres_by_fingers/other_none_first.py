robot.read_number(timeout=5)
if robot.number_shown == -1:
    robot.say("?")
else:
    robot.move_forward(robot.number_shown)
