robot.move_forward(4)
