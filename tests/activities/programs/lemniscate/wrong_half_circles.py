robot.pen(down=True)
robot.arc(0.75, 180)
robot.arc(0.75, -180)
