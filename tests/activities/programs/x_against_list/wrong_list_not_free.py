def ler__a__casa():
    global letra, n
    while True:
        robot.classify_gestures(timeout=10)
        letra = robot.gesture_result
        n = position_of(casas, letra)
        if n == 0:
            robot.say(join("Não há casa ", letra))
        elif not item(tabuleiro, n) == "":
            robot.say(join("A casa ", letra, " está ocupada"))
        else:
            return letra


def próxima__da__lista():
    return item(lista, jogadas / 2 + 0.5)


def levar__a__marca(casa, símbolo):
    robot.go_to_place(casa)
    robot.mark(símbolo)
    tabuleiro.replace_item(position_of(casas, casa), símbolo)


def três(a, b, c, símbolo):
    return item(tabuleiro, a) == símbolo and item(tabuleiro, b) == símbolo and item(tabuleiro, c) == símbolo


def ganhou(s):
    global k
    for k in steps(1, 3):
        if três(3 * k - 2, 3 * k - 1, 3 * k, s) or três(k, k + 3, k + 6, s):
            return True
    return três(1, 5, 9, s) or três(3, 5, 7, s)


casas = ["A", "B", "C", "D", "E", "F", "G", "I", "L"]
lista = ["E", "C", "G", "A", "I", "L", "B", "D", "F"]
tabuleiro = ["", "", "", "", "", "", "", "", ""]
vez = "X"
jogadas = 0
while not jogadas == 9:
    if vez == "X":
        levar__a__marca(ler__a__casa(), "X")
    else:
        levar__a__marca(próxima__da__lista(), "O")
    jogadas += 1
    if ganhou(vez):
        robot.say(join(vez, " ganhou"))
        break
    if jogadas == 9:
        robot.say("Deu velha")
    elif vez == "X":
        vez = "O"
    else:
        vez = "X"
