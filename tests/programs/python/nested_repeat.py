"""nested"""

for _ in range(2):
    for _ in range(3):
        robot.move_forward(0.2)
        robot.turn(90)
    robot.turn(90)
