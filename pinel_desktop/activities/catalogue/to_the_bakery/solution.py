robot.move_forward(3.0)
