"""tic-tac-toe A L G I"""

robot.move_forward(1.0)
robot.wait(1)
robot.turn(-45)
robot.move_forward(2.828427125)
robot.wait(1)
robot.turn(-135)
robot.move_forward(2.0)
robot.wait(1)
robot.turn(-90)
robot.move_forward(2.0)
robot.turn(-90)
robot.stop()
