robot.pen(down=True)
robot.arc(0.75, 360)
robot.arc(0.75, -360)
