"""The kinds of primitives, and the decorators that register them into the table."""

from collections.abc import Callable
from typing import NamedTuple

from pinel_desktop.execution.requests import Jump, Routine

# All take the context, the command, and the values of the command's expression parameters.
Instant = Callable[..., Jump | None]
Long = Callable[..., Routine]
Amount = Callable[..., float]


class Primitive(NamedTuple):
    """Implementation of a command; exactly one of `instant` and `routine` is set.

    Attributes:
        parameters: attributes of the command's model that hold expressions; evaluated before the command starts.
        instant: function of a command that takes no time; may return a jump out of enclosing bodies.
        routine: generator function; yields requests to the stack (`execution.requests`).
        is_flow: whether it runs other commands; such a command is not counted as one.
        is_loop: whether `break` and `continue` refer to it.
        amount: the command's goal in m, degrees or s from the parameter values; None without a goal.
    """

    parameters: tuple[str, ...] = ()
    instant: Instant | None = None
    routine: Long | None = None
    is_flow: bool = False
    is_loop: bool = False
    amount: Amount | None = None


TABLE: dict[str, Primitive] = {}


def instant(action: str, *parameters: str) -> Callable[[Instant], Instant]:
    """Registers a function that takes no time."""

    def register(function: Instant) -> Instant:
        TABLE[action] = Primitive(parameters, instant=function)
        return function

    return register


def timed(action: str, *parameters: str, amount: Amount | None = None) -> Callable[[Long], Long]:
    """Registers a generator function that yields None for each tick that it needs."""

    def register(function: Long) -> Long:
        TABLE[action] = Primitive(parameters, routine=function, amount=amount)
        return function

    return register


def flow(action: str, *parameters: str, loop: bool = False) -> Callable[[Long], Long]:
    """Registers a generator function that yields the bodies to run."""

    def register(function: Long) -> Long:
        TABLE[action] = Primitive(parameters, routine=function, is_flow=True, is_loop=loop)
        return function

    return register
