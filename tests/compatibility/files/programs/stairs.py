"""Escada"""


# um degrau, em metros
def degrau(altura):
    robot.move_forward(altura)
    robot.turn(90)
    robot.move_forward(0.1)
    robot.turn(-90)


total = 0
for i in steps(1, 3):
    degrau(i / 10)
    total += i
robot.say(total)
