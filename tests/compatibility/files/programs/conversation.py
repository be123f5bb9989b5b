"""Conversa"""

robot.classify_gestures(timeout=2)
if robot.gesture_result == "B":
    robot.mark("X")
else:
    robot.set_gesture_result("A")
nome = robot.ask("Como você se chama?")
lados = robot.ask("Quantos lados?")
robot.say(join("Oi, ", nome, "! ", 360 / lados, " graus"))
robot.pen(down=True, color="green")
for _ in range(lados):
    robot.move_forward(0.2)
    robot.turn(360 / lados)
robot.pen(down=False)
robot.mark("O")
robot.beep()
