def read__the__cell():
    global choice, number
    while True:
        robot.classify_gestures(timeout=20)
        choice = robot.gesture_result
        number = position_of(cells, choice)
        if number == 0:
            robot.say(join("There is no cell “", choice, "”: play again."))
        elif not item(board, number) == "":
            robot.say(join("Cell taken by “", item(board, number), "”: play again."))
        else:
            return number


def bring__the__mark(cell, player):
    robot.go_to_place(item(cells, cell))
    robot.mark(player)
    board.replace_item(cell, player)


def three__in__a__row(a, b, c, player):
    return item(board, a) == player and item(board, b) == player and item(board, c) == player


def has__won(player):
    global i
    for i in steps(1, 3):
        if three__in__a__row(i, i + 3, i + 6, player) or three__in__a__row(3 * i - 2, 3 * i - 1, 3 * i, player):
            return True
    return three__in__a__row(1, 5, 9, player) or three__in__a__row(3, 5, 7, player)


def cell__that__completes(player):
    global j, found
    for j in steps(1, 9):
        if item(board, j) == "":
            board.replace_item(j, player)
            found = has__won(player)
            board.replace_item(j, "")
            if found:
                return j
    return 0


def cell__of__the__computer():
    global number
    number = cell__that__completes("O")
    if number == 0:
        number = cell__that__completes("X")
    while number == 0:
        number = random_int(1, 9)
        if not item(board, number) == "":
            number = 0
    return number


cells = ["A", "B", "C", "D", "E", "F", "G", "I", "L"]
board = ["", "", "", "", "", "", "", "", ""]
turn = "X"
moves = 0
while moves < 9:
    if turn == "X":
        bring__the__mark(read__the__cell(), turn)
    else:
        bring__the__mark(cell__of__the__computer(), turn)
    moves += 1
    if has__won(turn):
        robot.say(join(turn, " wins!"))
        break
    if moves == 9:
        robot.say("A draw!")
    if turn == "X":
        turn = "O"
    else:
        turn = "X"
