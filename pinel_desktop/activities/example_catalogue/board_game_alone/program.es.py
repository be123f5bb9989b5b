def leer__la__casilla():
    global elección, número
    while True:
        robot.classify_gestures(timeout=20)
        elección = robot.gesture_result
        número = position_of(casillas, elección)
        if número == 0:
            robot.say(join("No hay casilla “", elección, "”: jueguen de nuevo."))
        elif not item(tablero, número) == "":
            robot.say(join("Casilla ocupada por “", item(tablero, número), "”: jueguen de nuevo."))
        else:
            return número


def llevar__la__marca(casilla, jugador):
    robot.go_to_place(item(casillas, casilla))
    robot.mark(jugador)
    tablero.replace_item(casilla, jugador)


def tres__en__línea(a, b, c, jugador):
    return item(tablero, a) == jugador and item(tablero, b) == jugador and item(tablero, c) == jugador


def ganó(jugador):
    global i
    for i in steps(1, 3):
        if tres__en__línea(i, i + 3, i + 6, jugador) or tres__en__línea(3 * i - 2, 3 * i - 1, 3 * i, jugador):
            return True
    return tres__en__línea(1, 5, 9, jugador) or tres__en__línea(3, 5, 7, jugador)


def casilla__que__completa(jugador):
    global j, encontró
    for j in steps(1, 9):
        if item(tablero, j) == "":
            tablero.replace_item(j, jugador)
            encontró = ganó(jugador)
            tablero.replace_item(j, "")
            if encontró:
                return j
    return 0


def casilla__de__la__computadora():
    global número
    número = casilla__que__completa("O")
    if número == 0:
        número = casilla__que__completa("X")
    while número == 0:
        número = random_int(1, 9)
        if not item(tablero, número) == "":
            número = 0
    return número


casillas = ["A", "B", "C", "D", "E", "F", "G", "I", "L"]
tablero = ["", "", "", "", "", "", "", "", ""]
turno = "X"
jugadas = 0
while jugadas < 9:
    if turno == "X":
        llevar__la__marca(leer__la__casilla(), turno)
    else:
        llevar__la__marca(casilla__de__la__computadora(), turno)
    jugadas += 1
    if ganó(turno):
        robot.say(join(turno, " ganó."))
        break
    if jugadas == 9:
        robot.say("¡Empate!")
    if turno == "X":
        turno = "O"
    else:
        turno = "X"
