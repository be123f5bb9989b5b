"""What a running command may ask of the stack, by yielding it.

None lets a tick pass; `Pending.PERSON` waits for a person or a camera, in real time.
"""

from collections.abc import Generator
from enum import Enum
from typing import Any, NamedTuple

from pinel_desktop.execution.expressions.requests import Invoke, Preempt
from pinel_desktop.execution.expressions.values import Value
from pinel_desktop.execution.inputs import Pending

__all__ = ["Body", "Invoke", "Jump", "Leave", "Preempt", "Returned", "Routine"]


class Body(NamedTuple):
    """Commands that a control-flow command wants run next; `path` is their place inside it, as a pointer."""

    commands: list[Any]
    path: str


class Leave(Enum):
    """A command is over and takes bodies around it with it."""

    LOOP = "break"
    ROUND = "continue"


class Returned(NamedTuple):
    """A command is over, and so is the function around it."""

    value: Value | None


Jump = Leave | Returned
Routine = Generator[Body | Invoke | Pending | Preempt | None, Value | None, Jump | None]
