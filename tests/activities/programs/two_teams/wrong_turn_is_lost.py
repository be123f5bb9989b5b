casas = ["A", "B", "C", "D", "E", "F", "G", "I", "L"]
tem = ["", "", "", "", "", "", "", "", ""]
linhas = [1, 2, 3, 4, 5, 6, 7, 8, 9, 1, 4, 7, 2, 5, 8, 3, 6, 9, 1, 5, 9, 3, 5, 7]
vez = "X"
marcas = 0
fim = False
while not fim:
    if vez == "X":
        robot.classify_gestures(timeout=10)
        casa = robot.gesture_result
    else:
        casa = robot.ask("O: qual casa?")
    n = position_of(casas, casa)
    if n > 0 and not contains(["X", "O"], item(tem, max(n, 1))):
        robot.go_to_place(item(casas, n))
        robot.mark(vez)
        tem.replace_item(n, vez)
        marcas += 1
        for k in steps(1, 22, 3):
            if item(tem, item(linhas, k)) == vez and item(tem, item(linhas, k + 1)) == vez and item(tem, item(linhas, k + 2)) == vez:
                robot.say(join(vez, " ganhou"))
                fim = True
        if marcas == 9 and not fim:
            robot.say("deu velha")
            fim = True
    if vez == "X":
        vez = "O"
    else:
        vez = "X"
