"""What a running command may ask of the stack, by yielding it; yielding None lets a tick pass."""

from collections.abc import Generator
from enum import Enum
from typing import Any, NamedTuple

from pinel_desktop.execution.values import Value


class Body(NamedTuple):
    """Commands that a control-flow command wants run next; `path` is their place inside it, as a pointer."""

    commands: list[Any]
    path: str


class Invoke(NamedTuple):
    """A function that is to run; the yield gives its value, None where it returned none."""

    function: str
    arguments: dict[str, Value]


class Breath(Enum):
    """A long calculation lets others have a look, such as for Stop: the step ends, the tick goes on."""

    TAKEN = 0


class Leave(Enum):
    """A command is over and takes bodies around it with it."""

    LOOP = "break"
    ROUND = "continue"


class Returned(NamedTuple):
    """A command is over, and so is the function around it."""

    value: Value | None


Jump = Leave | Returned
Asked = Generator[Invoke | Breath, Value | None, Value]
Routine = Generator[Body | Invoke | Breath | None, Value | None, Jump | None]
