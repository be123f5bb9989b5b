"""The three kinds of primitives, and the decorators that enter them into the table."""

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

from pinel_desktop.execution.context import RunContext


class Body(NamedTuple):
    """Commands that a control-flow command wants run next; `path` is their place inside it, as a pointer."""

    commands: list[Any]
    path: str


Instant = Callable[[RunContext, Any], None]
Timed = Callable[[RunContext, Any], Iterator[None]]
Flow = Callable[[RunContext, Any], Iterator[Body]]
Amount = Callable[[Any], float]


class Primitive(NamedTuple):
    """What a command does; exactly one of the three is set.

    Attributes:
        instant: is over at once.
        timed: yields once for each tick it needs.
        flow: yields the bodies to run, one after the other; its state lives in the generator.
        amount: the command's goal in m, degrees or s, for those that have one.
    """

    instant: Instant | None = None
    timed: Timed | None = None
    flow: Flow | None = None
    amount: Amount | None = None


TABLE: dict[str, Primitive] = {}


def instant(action: str) -> Callable[[Instant], Instant]:
    """Enters a function that is over at once."""

    def enter(function: Instant) -> Instant:
        TABLE[action] = Primitive(instant=function)
        return function

    return enter


def timed(action: str, amount: Amount | None = None) -> Callable[[Timed], Timed]:
    """Enters a generator function that yields once for each tick it needs."""

    def enter(function: Timed) -> Timed:
        TABLE[action] = Primitive(timed=function, amount=amount)
        return function

    return enter


def flow(action: str) -> Callable[[Flow], Flow]:
    """Enters a generator function that yields the bodies to run."""

    def enter(function: Flow) -> Flow:
        TABLE[action] = Primitive(flow=function)
        return function

    return enter
