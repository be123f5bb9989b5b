secret = random_int(1, 5)
guess = 0
while not guess == secret:
    guess = robot.ask("From 1 to 5, what is my number?")
    if guess < secret:
        robot.move_forward(0.5)
    elif guess > secret:
        robot.move_backward(0.5)
robot.turn(360)
