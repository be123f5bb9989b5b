robot.move_forward(5.7275)
