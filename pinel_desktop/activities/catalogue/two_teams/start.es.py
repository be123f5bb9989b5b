def leer__la__casilla():
    global letra
    while True:
        robot.classify_gestures(timeout=20)
        letra = robot.gesture_result
        if position_of(casillas, letra) == 0:
            robot.say(join("No hay casilla ", letra))
        else:
            return letra


def llevar__la__marca(casilla, símbolo):
    robot.go_to_place(casilla)
    robot.mark(símbolo)
    tablero.replace_item(position_of(casillas, casilla), símbolo)


def tres(a, b, c, símbolo):
    return item(tablero, a) == símbolo and item(tablero, b) == símbolo and item(tablero, c) == símbolo


casillas = ["A", "B", "C", "D", "E", "F", "G", "I", "L"]
tablero = ["", "", "", "", "", "", "", "", ""]
turno = "X"
jugadas = 0
while jugadas < 9:
    llevar__la__marca(leer__la__casilla(), turno)
    jugadas += 1
