robot.pen(down=True)
robot.arc(0.6, -360)
robot.arc(0.6, 360)
