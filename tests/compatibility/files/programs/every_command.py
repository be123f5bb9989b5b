"""Tudo o que o robô sabe"""


# caminho de um lado, em metros
def lado(comprimento):
    robot.move_forward(comprimento)
    robot.turn(90)
    return comprimento * 4


def conta(n):
    global passos
    passos += 1
    if n > 0:
        return conta(n - 1)
    return passos


passos = 0
números = [1, 2.5, "três", True]
robot.set_speed(linear=0.5, angular=120)
robot.pen(down=True, color="red")
perímetro = lado(0.3)
lado(comprimento=0.2)
robot.say(join("perímetro: ", perímetro, " m, ", conta(3), " vezes"))
robot.pen(down=False)
robot.arc(0.2, 90)
robot.arc(-0.2, -90)
robot.drive(0.2, -30)
robot.wait(0.5)
robot.stop()
robot.wait_until(robot.time > 12, timeout=1)
robot.go_to(0.5, 0.2)
robot.go_to(1.0, 1.0, avoid=True)
robot.move_backward(0.2)
robot.mark("X")
robot.beep()
for i in steps(10, 1, -3):
    if i == 7:
        continue
    números.append(i)
for _ in range(2):
    robot.turn(-45)
while True:
    break
while not length(números) > 8:
    números.append(random_int(1, 6))
dobro = item(números, 2) ** 2 - 1.25 / 5
resto = 17 % 5
a__b = max(1, dobro, resto) + min(3, resto)
minha__área = round(abs(0 - 7.5)) * sqrt(16)
ângulos = join(round(sin(30) * 100), " ", round(cos(60) * 100), " ", round(tan(45) * 100))
robot.classify_gestures(timeout=2)
if robot.gesture_result == "B" or robot.gesture_result == "C":
    robot.say("sinal B")
elif robot.gesture_result != "" and not robot.bumper:
    robot.say(robot.gesture_result)
else:
    robot.set_gesture_result("A")
robot.classify_gestures(timeout=1)
nome = robot.ask("Como você se chama?")
idade = robot.ask("Quantos anos?")
if idade >= 10 and idade <= 12:
    robot.say(join(nome, " tem ", idade))
perto = robot.sonar(0) < 5 or robot.lidar(-90) < 8
frente = robot.distance("front")
robot.say(join(robot.cell, robot.floor, perto, frente > 0.1))
robot.say(join(round(robot.x), " ", round(robot.y), " ", robot.heading < 400))
robot.mark("O")
# fim
