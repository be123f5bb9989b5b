def leer__la__casilla(jugador):
    global elección, número
    while True:
        if jugador == "X":
            robot.classify_gestures(timeout=20)
            elección = robot.gesture_result
        else:
            elección = robot.ask("Juega O: ¿en qué casilla?")
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


casillas = ["A", "B", "C", "D", "E", "F", "G", "I", "L"]
tablero = ["", "", "", "", "", "", "", "", ""]
turno = "X"
jugadas = 0
while jugadas < 9:
    llevar__la__marca(leer__la__casilla(turno), turno)
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
