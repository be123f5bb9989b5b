"""What the evaluation of an expression may ask of the stack, by yielding it, and what it may touch of the run."""

from collections.abc import Generator
from enum import Enum
from random import Random
from typing import NamedTuple, Protocol

from pinel_desktop.execution.expressions.values import Value
from pinel_desktop.execution.expressions.variables import Variables
from pinel_desktop.robot import Pose2D, RobotModel, Sensors


class Invoke(NamedTuple):
    """A function that is to run; the yield gives its value, None where it returned none."""

    function: str
    arguments: dict[str, Value]


class Preempt(Enum):
    """A long calculation lets others have a look, such as for Stop: the step ends, the tick goes on."""

    TAKEN = 0


Evaluation = Generator[Invoke | Preempt, Value | None, Value]


class EvaluationContext(Protocol):
    """The part of `RunContext` that expressions read; they change `n_evaluated` only."""

    robot: RobotModel
    pose: Pose2D
    tick: int
    variables: Variables
    gesture_result: str
    n_evaluated: int

    @property
    def sensors(self) -> Sensors: ...

    @property
    def random(self) -> Random: ...
