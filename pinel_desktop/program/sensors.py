"""The sensors of the language, one row for each. Everything else about a sensor derives from its row.

| derived | by |
|---|---|
| model in a document, its faults | `expressions.py` |
| type of its value | `expression_checks.py` |
| Python form, both ways | `python_text/forms.py` |
| reading it in a run, bounds, cost | `execution/expressions/`, `sensing.py` and `evaluation.py` |
| block, generator, loader | `ui/src/blocks/table/sensor_rows.ts`, by `python -m scripts.reference` |
| rows of docs/program-document.md and docs/python-text.md, `schema.json` | the same command |

A link reads a sensor by the method of the sensor's name in its `robot.Sensors`, in SI units and radians; without
the method the run fails with `sensor_missing`. The sensor's texts on the page are in `ui/src/i18n/LANG/blocks.ts`.
"""

import math
from dataclasses import dataclass
from typing import Literal, get_args

from pinel_desktop.program.operators import ValueType

DEGREES = "degrees"
Color = Literal["black", "red", "orange", "yellow", "green", "blue", "purple", "white"]
_TYPES: dict[ValueType, type] = {"number": float, "text": str, "boolean": bool}


@dataclass(frozen=True, slots=True)
class Argument:
    """The argument of a sensor: a number within bounds, or one of a few literal texts.

    Attributes:
        start: initial value on the block, and value in examples.
        low, high: bounds of a number.
        unit: of a number; degrees are passed to the link as radians.
        whole: True if the number must be whole; it is passed to the link as `int`.
        choices: the allowed texts; empty for a number.
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
        name: in documents, in Python (`robot.NAME`), and of the link's method.
        gives: type of the value.
        description: what it measures, for the tables of the docs.
        level: first level whose toolbox has its block.
        unit: of the value; the link gives degrees as radians.
        low, high: range of the value; None is unbounded.
        texts: all possible texts; empty if other texts are possible.
        argument: None for a sensor without an argument.
        block: type of its block, which sensors without an argument may share; empty is the name.
        cost: evaluation time, as a number of parts of an expression.
        simulated_only: True if no real robot can have it; a program that reads it is not run on a real robot.
        of_world: True if it measures the world around the robot, which a real robot's room replaces.
    """

    name: str
    gives: ValueType
    description: str
    level: Literal[2, 3]
    unit: str = ""
    low: float | None = None
    high: float | None = None
    texts: tuple[str, ...] = ()
    argument: Argument | None = None
    block: str = ""
    cost: int = 2
    simulated_only: bool = False
    of_world: bool = False

    @property
    def block_type(self) -> str:
        """Type of the sensor's block."""
        return self.block or self.name

    def is_possible(self, value: object) -> bool:
        """True if the value has the sensor's type and is within its range."""
        if not isinstance(value, _TYPES[self.gives]):
            return False
        low = -math.inf if self.low is None else self.low
        high = math.inf if self.high is None else self.high
        return not isinstance(value, float) or low <= value <= high


_RAY = _MARKS = 20
_DIRECTION = Argument("direction", "front", choices=("front", "left", "right", "back"))

# in the order of the toolbox
_ROWS = (
    Sensor(
        "distance",
        "number",
        "how much room there is on a side: what the nearest of its sonars measures; "
        "ahead and behind without walls beside the way",
        level=2,
        unit="m",
        low=0.0,
        argument=_DIRECTION,
        block="distance_sensor",
        cost=_RAY,
        of_world=True,
    ),
    Sensor("bumper", "boolean", "whether the robot touches something", level=2, of_world=True),
    Sensor("x", "number", "how far ahead of its start the robot is", 2, "m", block="position"),
    Sensor("y", "number", "how far to the left of its start", 2, "m", block="position"),
    Sensor("heading", "number", "where it looks; left is positive", 2, DEGREES, -180.0, 180.0),
    Sensor("time", "number", "how long the run has taken", 2, "s", low=0.0),
    Sensor(
        "floor",
        "text",
        "colour of the floor under the robot",
        level=2,
        texts=get_args(Color),
        simulated_only=True,
        of_world=True,
    ),
    Sensor("has_mark", "boolean", "whether the place under the robot has a mark", 2, cost=_MARKS),
    Sensor(
        "mark_here",
        "text",
        'mark of the place under the robot, or ""; of several the last one',
        level=2,
        texts=("X", "O", ""),
        cost=_MARKS,
    ),
    Sensor(
        "cell",
        "text",
        'name of the place under the robot, or ""',
        level=3,
        simulated_only=True,
        of_world=True,
    ),
    Sensor(
        "compass",
        "number",
        "where it looks on the map: 0 is up (north), 90 to the right (east), whatever the start",
        level=3,
        unit=DEGREES,
        low=-180.0,
        high=180.0,
        simulated_only=True,
        of_world=True,
    ),
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
        of_world=True,
    ),
    Sensor(
        "lidar",
        "number",
        "how far it is from the laser scanner to what is at an angle from the heading",
        level=3,
        unit="m",
        low=0.0,
        high=8.0,
        argument=Argument("angle", 0, -180.0, 180.0, DEGREES),
        cost=_RAY,
        of_world=True,
    ),
)
SENSORS = {sensor.name: sensor for sensor in _ROWS}
