"""metres by fingers"""

robot.read_number(timeout=10)
robot.move_forward(robot.number_shown)
robot.read_number(timeout=10)
if robot.number_shown == -1:
    robot.say(join("n = ", robot.number_shown))
else:
    robot.move_backward(robot.number_shown)
