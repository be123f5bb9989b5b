"""The kinds of primitives, and the decorators that enter them into the table."""

from collections.abc import Callable
from typing import NamedTuple

from pinel_desktop.execution.requests import Jump, Routine

# All get the context, the command, and the values of the command's parameters that are expressions.
Instant = Callable[..., Jump | None]
Long = Callable[..., Routine]
Amount = Callable[..., float]


class Primitive(NamedTuple):
    """What a command does; exactly one of `instant` and `routine` is set.

    Attributes:
        parameters: attributes of the command's model that hold expressions, evaluated before it begins.
        instant: is over at once; what it returns ends bodies around it.
        routine: yields what it needs: ticks, bodies to run, values of functions.
        is_flow: whether it runs other commands, and is not counted as one itself.
        is_loop: whether `break` and `continue` speak of it.
        amount: the command's goal in m, degrees or s, for those that have one, from the values of the parameters.
    """

    parameters: tuple[str, ...] = ()
    instant: Instant | None = None
    routine: Long | None = None
    is_flow: bool = False
    is_loop: bool = False
    amount: Amount | None = None


TABLE: dict[str, Primitive] = {}


def instant(action: str, *parameters: str) -> Callable[[Instant], Instant]:
    """Enters a function that is over at once."""

    def enter(function: Instant) -> Instant:
        TABLE[action] = Primitive(parameters, instant=function)
        return function

    return enter


def timed(action: str, *parameters: str, amount: Amount | None = None) -> Callable[[Long], Long]:
    """Enters a generator function that yields None once for each tick it needs."""

    def enter(function: Long) -> Long:
        TABLE[action] = Primitive(parameters, routine=function, amount=amount)
        return function

    return enter


def flow(action: str, *parameters: str, loop: bool = False) -> Callable[[Long], Long]:
    """Enters a generator function that yields the bodies to run; its state lives in the generator."""

    def enter(function: Long) -> Long:
        TABLE[action] = Primitive(parameters, routine=function, is_flow=True, is_loop=loop)
        return function

    return enter
