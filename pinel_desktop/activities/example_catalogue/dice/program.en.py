dice = random_int(1, 6)
robot.say(dice)
for _ in range(dice):
    robot.move_forward(0.5)
