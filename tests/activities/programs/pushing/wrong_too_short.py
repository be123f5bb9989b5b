robot.move_forward(2)
