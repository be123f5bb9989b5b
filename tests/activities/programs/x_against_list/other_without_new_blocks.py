def número(letra):
    global i
    for i in steps(1, 9):
        if item(letras, i) == letra:
            return i
    return 0


def trocar(n, s):
    global velho, i, tem
    velho = tem
    tem = []
    for i in steps(1, 9):
        if i == n:
            tem.append(s)
        else:
            tem.append(item(velho, i))


def jogar(letra, s):
    global n, marcas, i, fim
    n = número(letra)
    robot.go_to(1 + (n - 1) % 3, (1 - n + (n - 1) % 3) / 3, avoid=True)
    if s == "X":
        robot.mark("X")
    else:
        robot.mark("O")
    trocar(n, s)
    marcas += 1
    for i in steps(1, 8):
        if item(tem, item(um, i)) == s and item(tem, item(dois, i)) == s and item(tem, item(três, i)) == s:
            robot.say(join(s, " ganhou"))
            fim = True
    if marcas == 9 and not fim:
        robot.say("deu velha")
        fim = True


letras = ["A", "B", "C", "D", "E", "F", "G", "I", "L"]
ordem = ["E", "C", "G", "A", "I", "L", "B", "D", "F"]
um = [1, 4, 7, 1, 2, 3, 1, 3]
dois = [2, 5, 8, 4, 5, 6, 5, 5]
três = [3, 6, 9, 7, 8, 9, 9, 7]
tem = [0, 0, 0, 0, 0, 0, 0, 0, 0]
marcas = 0
fim = False
while not fim:
    robot.classify_gestures(timeout=10)
    casa = número(robot.gesture_result)
    if casa > 0:
        if item(tem, casa) == 0:
            jogar(robot.gesture_result, "X")
            pedido = 1
            while not fim and pedido < 10:
                if item(tem, número(item(ordem, pedido))) == 0:
                    jogar(item(ordem, pedido), "O")
                    pedido = 10
                pedido += 1
