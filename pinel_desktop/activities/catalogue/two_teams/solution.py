def ler__a__casa(jogador):
    global escolha, número
    while True:
        if jogador == "X":
            robot.classify_gestures(timeout=20)
            escolha = robot.gesture_result
        else:
            escolha = robot.ask("O joga: em que casa?")
        número = position_of(casas, escolha)
        if número == 0:
            robot.say(join("Não há casa “", escolha, "”: joguem de novo."))
        elif not item(tabuleiro, número) == "":
            robot.say(join("Casa ocupada por “", item(tabuleiro, número), "”: joguem de novo."))
        else:
            return número


def levar__a__marca(casa, jogador):
    robot.go_to_place(item(casas, casa))
    robot.mark(jogador)
    tabuleiro.replace_item(casa, jogador)


def três__em__linha(a, b, c, jogador):
    return item(tabuleiro, a) == jogador and item(tabuleiro, b) == jogador and item(tabuleiro, c) == jogador


def ganhou(jogador):
    global i
    for i in steps(1, 3):
        if três__em__linha(i, i + 3, i + 6, jogador) or três__em__linha(3 * i - 2, 3 * i - 1, 3 * i, jogador):
            return True
    return três__em__linha(1, 5, 9, jogador) or três__em__linha(3, 5, 7, jogador)


casas = ["A", "B", "C", "D", "E", "F", "G", "I", "L"]
tabuleiro = ["", "", "", "", "", "", "", "", ""]
vez = "X"
jogadas = 0
while jogadas < 9:
    levar__a__marca(ler__a__casa(vez), vez)
    jogadas += 1
    if ganhou(vez):
        robot.say(join(vez, " ganhou!"))
        break
    if jogadas == 9:
        robot.say("Deu velha!")
    if vez == "X":
        vez = "O"
    else:
        vez = "X"
