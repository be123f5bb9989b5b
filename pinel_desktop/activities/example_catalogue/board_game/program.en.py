def read__the__cell(player):
    global choice, number
    while True:
        if player == "X":
            robot.classify_gestures(timeout=20)
            choice = robot.gesture_result
        else:
            choice = robot.ask("O plays: in which cell?")
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


cells = ["A", "B", "C", "D", "E", "F", "G", "I", "L"]
board = ["", "", "", "", "", "", "", "", ""]
turn = "X"
moves = 0
while moves < 9:
    bring__the__mark(read__the__cell(turn), turn)
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
