robot.move_forward(5.6)
