"""into the wall"""

robot.move_forward(1.0)
robot.move_forward(6.0)
robot.turn(90)
