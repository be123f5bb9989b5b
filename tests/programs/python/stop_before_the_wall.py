"""stop before the wall"""

while not robot.distance("front") < 0.5:
    robot.move_forward(0.1)
robot.say(robot.cell)
