def read__the__cell():
    global letter
    while True:
        robot.classify_gestures(timeout=20)
        letter = robot.gesture_result
        if position_of(cells, letter) == 0:
            robot.say(join("There is no cell ", letter))
        else:
            return letter


def bring__the__mark(cell, symbol):
    robot.go_to_place(cell)
    robot.mark(symbol)
    board.replace_item(position_of(cells, cell), symbol)


def three(a, b, c, symbol):
    return item(board, a) == symbol and item(board, b) == symbol and item(board, c) == symbol


cells = ["A", "B", "C", "D", "E", "F", "G", "I", "L"]
order = ["E", "C", "G", "A", "I", "L", "B", "D", "F"]
board = ["", "", "", "", "", "", "", "", ""]
turn = "X"
moves = 0
while moves < 9:
    bring__the__mark(read__the__cell(), turn)
    moves += 1
