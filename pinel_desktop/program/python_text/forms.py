"""How each command and expression is spelled in Python: one form per construct, read and written from here.

docs/python-text.md is this table for people; a test holds the two together.
"""

import keyword
from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True, slots=True)
class Parameter:
    """A parameter of a command.

    Attributes:
        keyword: written with its name, as in `timeout=5`.
        optional: may be left out.
        default: value with which it is not written.
        literal: must be written out, as a text or as True or False, and is no expression.
        metres: a plain number is written with its decimal point, as in `1.0`.
    """

    name: str
    keyword: bool = False
    optional: bool = False
    default: object = None
    literal: Literal["text", "boolean"] | None = None
    metres: bool = False


@dataclass(frozen=True, slots=True)
class Form:
    """A call such as `robot.turn(90)`; the example is what a person is shown."""

    example: str
    parameters: tuple[Parameter, ...] = ()


_DISTANCE = (Parameter("distance", metres=True),)
COMMANDS: dict[str, Form] = {
    "move_forward": Form("robot.move_forward(1.0)", _DISTANCE),
    "move_backward": Form("robot.move_backward(1.0)", _DISTANCE),
    "turn": Form("robot.turn(90)", (Parameter("angle"),)),
    "stop": Form("robot.stop()"),
    "drive": Form("robot.drive(0.2, 30)", (Parameter("linear", metres=True), Parameter("angular"))),
    "arc": Form("robot.arc(1.0, 90)", (Parameter("radius", metres=True), Parameter("angle"))),
    "set_speed": Form(
        "robot.set_speed(linear=0.3, angular=45)",
        (
            Parameter("linear", keyword=True, optional=True, metres=True),
            Parameter("angular", keyword=True, optional=True),
        ),
    ),
    "go_to": Form(
        "robot.go_to(2.0, 1.0, avoid=True)",
        (
            Parameter("x", metres=True),
            Parameter("y", metres=True),
            Parameter("avoid", keyword=True, optional=True, default=False, literal="boolean"),
        ),
    ),
    "wait": Form("robot.wait(2)", (Parameter("seconds"),)),
    "wait_until": Form(
        "robot.wait_until(robot.bumper, timeout=5)",
        (Parameter("condition"), Parameter("timeout", keyword=True, optional=True)),
    ),
    "pen": Form(
        'robot.pen(down=True, color="red")',
        (
            Parameter("down", keyword=True, literal="boolean"),
            Parameter("color", keyword=True, optional=True, literal="text"),
        ),
    ),
    "mark": Form('robot.mark("X")', (Parameter("symbol", literal="text"),)),
    "say": Form('robot.say("Hello")', (Parameter("text"),)),
    "beep": Form("robot.beep()"),
    "classify_gestures": Form(
        "robot.classify_gestures(timeout=10)",
        (Parameter("timeout", keyword=True, optional=True),),
    ),
    "set_gesture_result": Form('robot.set_gesture_result("B")', (Parameter("result"),)),
}
ASK = Form('name = robot.ask("What is your name?")', (Parameter("question"),))

# sensors that are calls, with the parameter they have; the others are `robot.NAME`
SENSOR_CALLS: dict[str, Form] = {
    "sonar": Form("robot.sonar(0)", (Parameter("index"),)),
    "distance": Form('robot.distance("front")', (Parameter("direction", literal="text"),)),
    "lidar": Form("robot.lidar(0)", (Parameter("angle"),)),
}
MEASURES = ("x", "y", "heading", "bumper", "time", "floor", "cell")
GESTURE_RESULT = "gesture_result"

FUNCTIONS = (
    "min",
    "max",
    "abs",
    "round",
    "sqrt",
    "sin",
    "cos",
    "tan",
    "random_int",
    "join",
    "length",
    "item",
)
# names that mean something here already
RESERVED = frozenset(keyword.kwlist) | {"robot", "range", "steps"} | frozenset(FUNCTIONS)

# how tightly operators bind, from the loosest
OR, AND, NOT, COMPARISON, SUM, PRODUCT, SIGN, POWER, ATOM = range(9)
PRECEDENCE: dict[str, int] = {
    "or": OR,
    "and": AND,
    "not": NOT,
    **dict.fromkeys(("==", "!=", "<", "<=", ">", ">="), COMPARISON),
    **dict.fromkeys(("+", "-"), SUM),
    **dict.fromkeys(("*", "/", "%"), PRODUCT),
    "**": POWER,
}

# what pupils know from other Python, and how it is said here
INSTEAD = {
    "print": 'robot.say("...")',
    "input": 'x = robot.ask("...")',
    "len": "length(x)",
    "str": 'join("x = ", x)',
    "int": "round(x)",
    "float": "x",
    "sum": "x = x + 1",
    "pow": "x ** 2",
    "sleep": "robot.wait(1)",
    "randint": "random_int(1, 6)",
    "random": "random_int(1, 6)",
}
