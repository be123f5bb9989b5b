"""to the red"""

while not robot.floor == "red":
    robot.move_forward(0.1)
robot.say(robot.cell)
