def ir(n):
    robot.go_to(1 + (n - 1) % 3, (1 - n + (n - 1) % 3) / 3)


def livre(n):
    ir(n)
    return not robot.has_mark


def linha(a, b, c, s):
    global w
    if item(de, a) == s and item(de, b) == s and item(de, c) == s:
        w = s


def olhar(s):
    global w
    linha(1, 2, 3, s)
    linha(4, 5, 6, s)
    linha(7, 8, 9, s)
    linha(1, 4, 7, s)
    linha(2, 5, 8, s)
    linha(3, 6, 9, s)
    linha(1, 5, 9, s)
    linha(3, 5, 7, s)


def pôr(n, s):
    robot.mark(s)
    de.replace_item(n, robot.mark_here)
    olhar(s)


w = ""
de = ["-", "-", "-", "-", "-", "-", "-", "-", "-"]
for rodada in steps(1, 5):
    n = 0
    while n == 0:
        robot.classify_gestures(timeout=20)
        n = position_of(["A", "B", "C", "D", "E", "F", "G", "I", "L"], robot.gesture_result)
        if n > 0:
            if not livre(n):
                n = 0
    pôr(n, "X")
    if w == "X" or rodada == 5:
        break
    i = 1
    while not livre(item([5, 3, 7, 1, 8, 9, 2, 4, 6], i)):
        i += 1
    pôr(item([5, 3, 7, 1, 8, 9, 2, 4, 6], i), "O")
    if w == "O":
        break
if w == "":
    robot.say("deu velha!")
else:
    robot.say(join("Acabou: ", w, " ganhou!"))
