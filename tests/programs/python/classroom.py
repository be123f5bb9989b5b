"""worksheets for the first column"""

robot.turn(90)
robot.move_forward(4.175)
robot.turn(-90)
robot.move_forward(2.4)
robot.turn(-90)
robot.move_forward(0.675)
robot.say(robot.cell)
for _ in range(2):
    robot.move_forward(1.5)
    robot.say(robot.cell)
