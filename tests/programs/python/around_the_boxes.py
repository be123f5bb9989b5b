"""around the boxes"""

robot.turn(90)
robot.move_forward(1.1)
robot.turn(-90)
robot.move_forward(0.2)
