"""half turns"""

robot.turn(180)
robot.turn(-180)
robot.turn(270)
robot.turn(-630)
