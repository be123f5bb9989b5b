robot.move_forward(0.3)
