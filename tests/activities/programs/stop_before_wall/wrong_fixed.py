robot.move_forward(6.2)
