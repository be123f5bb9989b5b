"""Programs for the screenshots, in Blockly's serialised form."""

from typing import Any

Block = dict[str, Any]


def chain(*blocks: Block) -> Block:
    """Connects blocks to a stack."""
    first, *others = blocks
    return {**first, "next": {"block": chain(*others)}} if others else first


def number(value: float) -> Block:
    """Returns an input with its shadow block."""
    return {"shadow": {"type": "number", "fields": {"NUM": value}}}


def forward(distance: float) -> Block:
    return {"type": "move_forward", "inputs": {"DISTANCE": number(distance)}}


def turn(angle: float, direction: str = "LEFT") -> Block:
    return {
        "type": "turn",
        "fields": {"DIRECTION": direction},
        "inputs": {"ANGLE": number(angle)},
    }


def repeat(times: int, *blocks: Block) -> Block:
    return {"type": "repeat", "inputs": {"TIMES": number(times), "DO": {"block": chain(*blocks)}}}


def sign(timeout: int) -> Block:
    return {"type": "classify_gestures", "inputs": {"TIMEOUT": number(timeout)}}


def when_sign(letter: str, *blocks: Block) -> Block:
    compare = {
        "type": "compare",
        "fields": {"OPERATOR": "=="},
        "inputs": {
            "A": {"block": {"type": "gesture_result"}},
            "B": {"shadow": {"type": "text_letter", "fields": {"TEXT": letter}}},
        },
    }
    inputs = {"CONDITION": {"block": compare}, "THEN": {"block": chain(*blocks)}}
    return {"type": "if", "inputs": inputs}


def wait(seconds: float) -> Block:
    return {"type": "wait", "inputs": {"SECONDS": number(seconds)}}


def workspace(*blocks: Block) -> dict[str, Any]:
    start: Block = {"type": "program_start", "x": 40, "y": 40}
    start["next"] = {"block": chain(*blocks)}
    return {"blocks": {"languageVersion": 0, "blocks": [start]}}


SQUARE = workspace(repeat(4, forward(1), turn(90)))
TRIANGLE = workspace(repeat(3, forward(1.5), turn(120)), wait(1))
STAR = workspace(repeat(5, forward(1.6), turn(144, "RIGHT")))
WALL = workspace(turn(90), forward(1.2), turn(90, "RIGHT"), forward(9))
WEAK = workspace(forward(2), turn(90), forward(2))
SIGNS = workspace(sign(30), when_sign("B", repeat(4, forward(1), turn(90))), forward(0.5))
FAULTY = workspace(forward(1), {"type": "if", "inputs": {"THEN": {"block": turn(90)}}}, turn(45))
