robot.move_forward(3.0)
robot.turn(180)
robot.move_forward(3.0)
