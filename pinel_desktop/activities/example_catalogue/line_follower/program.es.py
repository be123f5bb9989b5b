última = ""
estaciones = 0
while estaciones < 4:
    robot.drive(0.2, 14)
    robot.wait_until(robot.floor == "white")
    while robot.floor == "white":
        robot.turn(-15)
        robot.drive(0.2, 0)
        robot.wait_until(robot.floor != "white", timeout=0.5)
    if robot.cell != "" and robot.cell != última:
        última = robot.cell
        estaciones += 1
        robot.say(última)
robot.stop()
