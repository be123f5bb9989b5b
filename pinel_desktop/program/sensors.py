"""The sensors of the language: one row each. Everything else about a sensor is derived from its row.

| derived | by |
|---|---|
| model in a document, its faults | `expressions.py` |
| type of its value | `expression_checks.py` |
| Python form, both ways | `python_text/forms.py` |
| reading it in a run, bounds, cost | `execution/expressions/`, `sensing.py` and `evaluation.py` |
| block, generator, loader | `ui/src/blocks/table/sensor_rows.ts`, by `python -m scripts.reference` |
| rows of docs/program-document.md and docs/python-text.md, `schema.json` | the same command |

A link reads it by a method of its name on its `robot.Sensors`, in SI units and radians; a link without the method fails
the run with `sensor_missing`. Its words on the page are in `ui/src/i18n/LANG/blocks.ts`.
"""

import math
from dataclasses import dataclass
from typing import Literal

from pinel_desktop.program.operators import ValueType

DEGREES = "degrees"
_TYPES: dict[ValueType, type] = {"number": float, "text": str, "boolean": bool}


@dataclass(frozen=True, slots=True)
class Argument:
    """What a sensor is asked: a number within bounds, or one of a few texts that must be written out.

    Attributes:
        start: what stands on the block and in examples.
        low, high: bounds of a number.
        unit: of a number; degrees reach the link as radians.
        whole: whether only whole numbers will do; they reach the link as `int`.
        choices: the texts; empty for a number.
    """

    name: str
    start: float | str
    low: float = 0.0
    high: float = 0.0
    unit: str = ""
    whole: bool = False
    choices: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Sensor:
    """A row of the table.

    Attributes:
        name: in documents, in Python (`robot.NAME`) and of the method of a link.
        gives: type of the value.
        says: what it measures, for the tables of the docs.
        level: from which level on its block is in the toolbox.
        unit: of the value; degrees come from the link as radians.
        low, high: range of the value; None where there is no bound.
        argument: what it is asked; None for a plain value.
        block: type of its block, which sensors without an argument may share; the name where it is empty.
        cost: how many parts of an expression it takes as long as.
    """

    name: str
    gives: ValueType
    says: str
    level: Literal[2, 3]
    unit: str = ""
    low: float | None = None
    high: float | None = None
    argument: Argument | None = None
    block: str = ""
    cost: int = 2

    @property
    def block_type(self) -> str:
        """Type of the block that reads it."""
        return self.block or self.name

    def is_possible(self, value: object) -> bool:
        """Whether a value is of its type and within its range."""
        if not isinstance(value, _TYPES[self.gives]):
            return False
        low = -math.inf if self.low is None else self.low
        high = math.inf if self.high is None else self.high
        return not isinstance(value, float) or low <= value <= high


_RAY = 20
_DIRECTION = Argument("direction", "front", choices=("front", "left", "right", "back"))

# in the order of the toolbox
_ROWS = (
    Sensor(
        "distance",
        "number",
        "how much room there is on a side: what the nearest of its sonars measures",
        level=2,
        unit="m",
        low=0.0,
        argument=_DIRECTION,
        block="distance_sensor",
        cost=_RAY,
    ),
    Sensor("bumper", "boolean", "whether the robot touches something", level=2),
    Sensor("x", "number", "how far ahead of its start the robot is", 2, "m", block="position"),
    Sensor("y", "number", "how far to the left of its start", 2, "m", block="position"),
    Sensor("heading", "number", "where it looks; left is positive", 2, DEGREES, -180.0, 180.0),
    Sensor("time", "number", "how long the run has taken", 2, "s", low=0.0),
    Sensor("floor", "text", "colour of the floor under the robot", level=2),
    Sensor("cell", "text", 'name of the place under the robot, or ""', level=3),
    Sensor(
        "sonar",
        "number",
        "how far it is from the hull to what is ahead of a sonar; 5 when nothing is near",
        level=3,
        unit="m",
        low=0.0,
        high=5.0,
        argument=Argument("index", 0, 0.0, 15.0, whole=True),
        cost=_RAY,
    ),
    Sensor(
        "lidar",
        "number",
        "how far it is from the laser scanner to what is at an angle from the heading",
        level=3,
        unit="m",
        low=0.0,
        high=8.0,
        argument=Argument("angle", 0, -90.0, 90.0, DEGREES),
        cost=_RAY,
    ),
)
SENSORS = {sensor.name: sensor for sensor in _ROWS}
