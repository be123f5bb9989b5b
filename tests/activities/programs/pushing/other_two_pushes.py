robot.move_forward(3)
robot.move_forward(2.6)
