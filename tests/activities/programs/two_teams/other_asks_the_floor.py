def mudar():
    global vez
    if vez == "X":
        vez = "O"
    else:
        vez = "X"


def quem__está__em(casa):
    robot.go_to_place(casa)
    return robot.mark_here


def linha(a, b, c):
    global acabou
    if item(quem, a) == vez and item(quem, b) == vez and item(quem, c) == vez:
        acabou = join(vez, " ganhou")


vez = "X"
acabou = ""
quem = [1, 2, 3, 4, 5, 6, 7, 8, 9]
for jogada in steps(1, 9):
    valeu = False
    while not valeu:
        if vez == "X":
            robot.classify_gestures()
            casa = robot.gesture_result
        else:
            casa = robot.ask("E o O?")
        n = position_of(["A", "B", "C", "D", "E", "F", "G", "I", "L"], casa)
        if n > 0:
            if quem__está__em(casa) == "":
                valeu = True
    robot.mark(vez)
    quem.replace_item(n, vez)
    for k in steps(1, 3):
        linha(k, k + 3, k + 6)
        linha(3 * k - 2, 3 * k - 1, 3 * k)
    linha(1, 5, 9)
    linha(3, 5, 7)
    if not acabou == "":
        robot.say(acabou)
        break
    mudar()
if acabou == "":
    robot.say("Deu velha.")
