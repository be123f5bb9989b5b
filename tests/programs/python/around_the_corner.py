"""around the corner"""

robot.move_forward(3.0)
robot.turn(90)
robot.move_forward(3.0)
robot.say(robot.cell)
