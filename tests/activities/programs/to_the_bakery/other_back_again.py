robot.move_forward(4)
robot.move_backward(1)
