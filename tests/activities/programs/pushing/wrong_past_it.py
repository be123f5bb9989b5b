robot.turn(20)
robot.move_forward(5.6)
