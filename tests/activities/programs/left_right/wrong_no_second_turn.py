robot.move_forward(3)
robot.turn(90)
robot.move_forward(3)
robot.move_forward(3)
