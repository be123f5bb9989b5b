"""Generates `ui/src/api/declared.ts`: limits and choices that the page shares with Python."""

import json
from collections.abc import Iterable, Mapping

from pinel_desktop.gestures.letters import LETTERS
from pinel_desktop.program import limits as program
from pinel_desktop.program.model import MOTIONS
from pinel_desktop.robot import PIONEER_3DX
from sim import document, floor, world
from storage import choices
from storage import limits as store

_HEAD = "// Made by `python -m scripts.reference` from what Python declares. Do not edit.\n"
_PROGRAM = {
    "MAX_DISTANCE_M": program.MAX_DISTANCE_M,
    "MAX_ANGLE_DEG": program.MAX_ANGLE_DEG,
    "MAX_WAIT_S": program.MAX_WAIT_S,
    "MAX_LIST": program.MAX_LIST,
    "MAX_REPEATS": program.MAX_REPEATS,
}
_WORLD = {
    "MAX_BYTES": document.MAX_BYTES,
    "MAX_NAME": floor.MAX_NAME,
    "MAX_TITLE": document.MAX_TITLE,
    "MIN_FLOOR_M": document.MIN_FLOOR_M,
    "MAX_FLOOR_M": document.MAX_FLOOR_M,
    "MIN_MOVABLE_SIDE_M": world.MIN_MOVABLE_SIDE_M,
    "MIN_MOVABLE_KG": world.MIN_MOVABLE_KG,
    "MAX_MOVABLE_KG": world.MAX_MOVABLE_KG,
}
_STORE = {
    "MAX_NAME": store.MAX_NAME,
    "MAX_NOTE": store.MAX_NOTE,
    "MAX_SIGN": store.MAX_SIGN,
    "MAX_TAUGHT_SAMPLES": store.MAX_TAUGHT_SAMPLES,
}


def declared() -> str:
    """The text of the file."""
    return "\n".join(
        [
            _HEAD,
            "/** Limits of parameters: pinel_desktop/program/limits.py. */",
            _numbers("PROGRAM_LIMITS", _PROGRAM),
            "/** Commands that move the robot: pinel_desktop/program/model.py. */",
            _list("MOTIONS", MOTIONS),
            "/** Limits of a world: sim/document.py, floor.py, world.py. */",
            _numbers("WORLD_LIMITS", _WORLD),
            "/** The world of a program for which none was chosen: sim/world.py. */",
            f'export const DEFAULT_WORLD = "{world.DEFAULT_WORLD}";\n',
            "/** The robot model of a program for which none was chosen: pinel_desktop/robot/models.py. */",
            f'export const DEFAULT_ROBOT = "{PIONEER_3DX.name}";\n',
            "/** Limits of stored texts, in characters: storage/limits.py. */",
            _numbers("STORE_LIMITS", _STORE),
            "/** Colours of groups: storage/choices.py. */",
            _list("GROUP_COLORS", choices.COLORS),
            "/** Patterns of a group's robot: storage/choices.py. */",
            _list("ROBOT_PATTERNS", choices.PATTERNS),
            "/** Letters that the camera knows untaught: pinel_desktop/gestures/letters.py. */",
            _list("LETTERS", LETTERS),
        ]
    )


def _numbers(name: str, values: Mapping[str, float]) -> str:
    lines = [f"  {key}: {value:.15g},\n" for key, value in values.items()]
    return f"export const {name} = {{\n{''.join(lines)}}} as const;\n"


def _list(name: str, values: Iterable[str]) -> str:
    lines = [f"  {json.dumps(value)},\n" for value in values]
    return f"export const {name} = [\n{''.join(lines)}] as const;\n"
