"""from the living room to the kitchen"""

robot.move_forward(1.4)
robot.turn(90)
robot.move_forward(1.7)
robot.turn(-90)
robot.move_forward(2.5)
robot.say(robot.cell)
robot.go_to(5.8, 2.1)
robot.say(robot.cell)
robot.go_to(7.4, 3.8)
robot.say(robot.cell)
