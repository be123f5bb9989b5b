"""Requests that evaluation yields to the stack, and the part of the run that it may use."""

from collections.abc import Generator
from enum import Enum
from random import Random
from typing import NamedTuple, Protocol

from pinel_desktop.execution.expressions.values import Value
from pinel_desktop.execution.expressions.variables import Variables
from pinel_desktop.execution.places import MarkedPlaces
from pinel_desktop.robot import Pose2D, RobotModel, Sensors


class Invoke(NamedTuple):
    """Runs a function; the yield returns its value, None without one."""

    function: str
    arguments: dict[str, Value]


class Preempt(Enum):
    """Ends the step within the tick, so that a long calculation reacts to Stop."""

    YIELD = 0


Evaluation = Generator[Invoke | Preempt, Value | None, Value]


class EvaluationContext(Protocol):
    """The part of `RunContext` that expressions use; they write only `n_evaluated`."""

    robot: RobotModel
    pose: Pose2D
    tick: int
    variables: Variables
    gesture_result: str
    number_shown: int
    marked: MarkedPlaces
    semantics: int
    n_evaluated: int

    @property
    def sensors(self) -> Sensors: ...

    @property
    def random(self) -> Random: ...
