"""there and back"""

robot.move_forward(1.5)
robot.wait(0.5)
robot.move_backward(1.5)
