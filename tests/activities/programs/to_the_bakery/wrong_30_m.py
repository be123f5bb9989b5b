robot.move_forward(30)
