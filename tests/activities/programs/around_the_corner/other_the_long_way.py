robot.move_forward(3)
robot.turn(-270)
robot.move_forward(3)
