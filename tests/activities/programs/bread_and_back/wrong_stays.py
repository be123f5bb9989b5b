robot.move_forward(3)
robot.turn(180)
