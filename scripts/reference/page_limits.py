"""`ui/src/api/limits.ts`: limits that the page's fields hold a person to."""

from pinel_desktop.program import limits as program
from sim import document, floor, world
from storage import limits as store

_HEAD = "// Made by `python -m scripts.reference` from what Python declares. Do not edit.\n"


def page_limits() -> str:
    """The file."""
    return _HEAD + "".join(
        [
            _constants(
                "PROGRAM_LIMITS",
                "Limits of parameters: pinel_desktop/program/limits.py.",
                {
                    "MAX_DISTANCE_M": program.MAX_DISTANCE_M,
                    "MAX_ANGLE_DEG": program.MAX_ANGLE_DEG,
                    "MAX_WAIT_S": program.MAX_WAIT_S,
                    "MAX_REPEATS": program.MAX_REPEATS,
                },
            ),
            _constants(
                "WORLD_LIMITS",
                "Limits of a world: sim/document.py, floor.py, world.py.",
                {
                    "MAX_BYTES": document.MAX_BYTES,
                    "MAX_NAME": floor.MAX_NAME,
                    "MAX_TITLE": document.MAX_TITLE,
                    "MIN_FLOOR_M": document.MIN_FLOOR_M,
                    "MAX_FLOOR_M": document.MAX_FLOOR_M,
                    "MIN_MOVABLE_SIDE_M": world.MIN_MOVABLE_SIDE_M,
                    "MIN_MOVABLE_KG": world.MIN_MOVABLE_KG,
                    "MAX_MOVABLE_KG": world.MAX_MOVABLE_KG,
                },
            ),
            _constants(
                "STORE_LIMITS",
                "Limits of what is kept, in letters: storage/limits.py.",
                {"MAX_NAME": store.MAX_NAME, "MAX_NOTE": store.MAX_NOTE},
            ),
        ]
    )


def _constants(name: str, about: str, values: dict[str, float]) -> str:
    lines = [f"  {key}: {value:.15g},\n" for key, value in values.items()]
    return f"\n/** {about} */\nexport const {name} = {{\n{''.join(lines)}}} as const;\n"
