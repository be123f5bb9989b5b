robot.move_forward(3)
robot.move_backward(3)
