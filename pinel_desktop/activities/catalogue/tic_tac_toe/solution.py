robot.move_forward(1.0)
robot.turn(-45)
robot.move_forward(2.83)
