robot.move_forward(7)
