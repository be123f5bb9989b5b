robot.pen(down=True, color="purple")
for i in steps(1, 7):
    robot.arc(i * 0.2, 180)
