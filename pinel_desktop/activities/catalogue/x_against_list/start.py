def ler__a__casa():
    global letra
    while True:
        robot.classify_gestures(timeout=20)
        letra = robot.gesture_result
        if position_of(casas, letra) == 0:
            robot.say(join("Não há casa ", letra))
        else:
            return letra


def levar__a__marca(casa, símbolo):
    robot.go_to_place(casa)
    robot.mark(símbolo)
    tabuleiro.replace_item(position_of(casas, casa), símbolo)


def três(a, b, c, símbolo):
    return item(tabuleiro, a) == símbolo and item(tabuleiro, b) == símbolo and item(tabuleiro, c) == símbolo


casas = ["A", "B", "C", "D", "E", "F", "G", "I", "L"]
lista = ["E", "C", "G", "A", "I", "L", "B", "D", "F"]
tabuleiro = ["", "", "", "", "", "", "", "", ""]
vez = "X"
jogadas = 0
while jogadas < 9:
    levar__a__marca(ler__a__casa(), vez)
    jogadas += 1
