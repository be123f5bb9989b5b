"""triangle"""

for _ in range(3):
    robot.move_forward(1.0)
    robot.turn(120)
