"""Requests that a running command yields to the stack.

None requests a tick; `Pending.PERSON` waits for a person or a camera, in real time.
"""

from collections.abc import Generator
from enum import Enum
from typing import Any, NamedTuple

from pinel_desktop.execution.expressions.requests import Invoke, Preempt
from pinel_desktop.execution.expressions.values import Value
from pinel_desktop.execution.inputs import Pending

__all__ = ["Body", "Invoke", "Jump", "Leave", "Preempt", "Returned", "Routine"]


class Body(NamedTuple):
    """Commands for the stack to run next; `path` is their JSON pointer relative to the requesting command."""

    commands: list[Any]
    path: str


class Leave(Enum):
    """Jump out of enclosing bodies: out of the loop, or to the loop's next iteration."""

    LOOP = "break"
    ROUND = "continue"


class Returned(NamedTuple):
    """Jump out of the enclosing function, with its value."""

    value: Value | None


Jump = Leave | Returned
Routine = Generator[Body | Invoke | Pending | Preempt | None, Value | None, Jump | None]
