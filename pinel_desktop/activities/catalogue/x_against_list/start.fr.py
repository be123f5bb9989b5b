def lire__la__case():
    global lettre
    while True:
        robot.classify_gestures(timeout=20)
        lettre = robot.gesture_result
        if position_of(cases, lettre) == 0:
            robot.say(join("Il n’y a pas de case ", lettre))
        else:
            return lettre


def porter__la__marque(case, symbole):
    robot.go_to_place(case)
    robot.mark(symbole)
    plateau.replace_item(position_of(cases, case), symbole)


def trois(a, b, c, symbole):
    return item(plateau, a) == symbole and item(plateau, b) == symbole and item(plateau, c) == symbole


cases = ["A", "B", "C", "D", "E", "F", "G", "I", "L"]
liste = ["E", "C", "G", "A", "I", "L", "B", "D", "F"]
plateau = ["", "", "", "", "", "", "", "", ""]
tour = "X"
coups = 0
while coups < 9:
    porter__la__marque(lire__la__case(), tour)
    coups += 1
