"""Waiting for the input of a capture or a question."""

import math
from collections.abc import Generator
from typing import TypeVar

from pinel_desktop.events.model import Countdown, Event
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.inputs.sources import InputSource, Pending

_COUNTDOWN_HZ = 5

T = TypeVar("T")
Waiting = Generator[Pending | None, None, T | None]


def wait_for_input(
    context: RunContext,
    source: InputSource[T],
    announcement: Event,
    *,
    question: str = "",
    timeout_s: float = math.inf,
) -> Waiting[T]:
    """Emits `announcement`, then waits; returns the input, None after the timeout.

    The timeout counts real time without pauses for a person or a camera, otherwise robot time.
    """
    source.begin(question)  # before the announcement: an answer may come at once
    context.emit(announcement)
    try:
        return (yield from _polled(context, source, timeout_s))
    finally:
        source.cancel()


def _polled(context: RunContext, source: InputSource[T], timeout_s: float) -> Waiting[T]:
    n_ticks, start_s, reported = 0, context.waited_s, math.inf
    while isinstance(input_ := source.poll(), Pending):
        if input_ is Pending.TICK:
            if n_ticks >= max(1, _ticks(timeout_s)):
                return None
            n_ticks += 1
            yield None
            continue
        left_s = start_s + timeout_s - context.waited_s
        if left_s <= 0.0:
            return None
        if math.isfinite(left_s) and math.ceil(left_s * _COUNTDOWN_HZ) < reported:
            reported = math.ceil(left_s * _COUNTDOWN_HZ)
            context.emit(Countdown(round(left_s, 2)))
        yield input_
    return input_


def _ticks(timeout_s: float) -> float:
    return round(timeout_s * TICK_HZ) if math.isfinite(timeout_s) else math.inf
