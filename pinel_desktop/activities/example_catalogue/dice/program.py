dado = random_int(1, 6)
robot.say(dado)
for _ in range(dado):
    robot.move_forward(0.5)
