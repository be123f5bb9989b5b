robot.move_forward(2)
robot.turn(90)
robot.move_forward(1)
