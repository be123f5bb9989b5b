robot.pen(down=True, color="red")
for _ in range(6):
    robot.arc(0.7, 120)
    robot.turn(60)
    robot.arc(0.7, 120)
    robot.turn(120)
