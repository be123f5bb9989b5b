"""Inputs for the replay of a recorded run, given at the same ticks and between the same commands."""

import math
from collections import deque
from collections.abc import Callable, Iterable, Mapping
from decimal import Decimal
from typing import Any, Generic, Literal, NamedTuple, TypeVar

from pinel_desktop.errors import PinelError
from pinel_desktop.events.model import Event, PauseCause, RunState, Telemetry
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.failure import RunFailureError
from pinel_desktop.execution.inputs import Capture, Pending

WireEvent = Mapping[str, Any]


class _Request(NamedTuple):
    """A pause or stop that a person or a breakpoint requested.

    Attributes:
        event_index: index of the request among the recorded events; if it came together with an input, the input's
            index.
        at: the tick; for `hold`, the number of commands that had started.
        when: state of the run at that tick. In all states but `running` robot time was stopped: the run `awaited` a
            person, a person had just `answered`, or the run was `paused`.
    """

    what: Literal["pause", "hold", "stop"]
    event_index: float
    at: int
    cause: PauseCause = "person"
    when: Literal["running", "paused", "awaited", "answered"] = "running"


T = TypeVar("T")


class _Input(NamedTuple, Generic[T]):
    """A recorded result or answer, and its tick."""

    event_index: int
    tick: int
    given: T


class RecordedInputs:
    """Inputs and requests of a recorded run, for its replay.

    Args:
        events: events of the recorded run in their order, in wire format; telemetry may be missing.
        until_tick: the tick at which the replay stops; None for no limit.

    Raises PinelError `run_not_repeatable` if the record lacks the tick of a stop or the command of a pause,
    `run_damaged` if an event is malformed.
    """

    is_live = False

    def __init__(self, events: Iterable[WireEvent], until_tick: int | None = None) -> None:
        self.gestures = _Recorded[Capture](self)
        self.answers = _Recorded[str](self, self._answer_missing)
        self.tick = 0
        self._control = RunControl()
        self._is_paused = False  # a paused robot still comes to rest, which takes ticks
        self._requests: deque[_Request] = deque()
        self._ended: WireEvent = {}
        try:
            self._read(events)
        except (KeyError, TypeError, AttributeError) as error:
            raise PinelError("run_damaged", part="events") from error
        if until_tick is not None:
            self._requests.append(_Request("stop", math.inf, until_tick))

    def attach(self, control: RunControl) -> Callable[[int, Event], None]:
        """Passes recorded requests to `control`; returns the observer that must receive the replay's events."""
        self._control = control
        if self._ended.get("state") == "stopped":
            control.stop_reason = self._ended["reason"]
        return self._observe

    def is_requested_before(self, place: float) -> bool:
        """Returns whether a pause or stop is due that came during the wait for the input at event index `place`."""
        if not self._requests:
            return False
        request = self._requests[0]
        return request.when == "awaited" and self.tick >= request.at and request.event_index < place

    def stop_if_it_came_with(self, place: int) -> None:
        """Requests the stop that came at the same time as the input at event index `place`, if there is one."""
        if (
            self._requests
            and self._requests[0].when == "answered"
            and self._requests[0].event_index == place
        ):
            self._control.stop()

    def pause_or_stop(self) -> None:
        """Makes the next recorded request."""
        if self._requests[0].what == "stop":
            self._control.stop()
        else:
            self._control.pause()

    def _answer_missing(self, question: str) -> None:
        if self._ended.get("reason") == "answer_missing":
            raise RunFailureError("answer_missing", question=question)

    def _observe(self, tick: int, event: Event) -> None:
        if type(event) is Telemetry:
            self.tick = tick
            if self._requests and not self._is_paused:
                self._request()
        elif type(event) is RunState:
            self._is_paused = event.state == "paused"
            if self._is_paused:
                self._resume()
            else:
                self._request()

    def _read(self, events: Iterable[WireEvent]) -> None:
        moment = _RecordCursor()
        for place, event in enumerate(events):
            moment.follow(place, event)
            match event["type"]:
                case "run_state" if event["state"] == "paused":
                    self._requests.append(_pause(place, event, moment))
                case "gesture_result" if event["source"] == "capture":
                    self.gestures.recorded.append(_Input(place, event["tick"], _capture(event)))
                case "answered":
                    answer = _as_typed(event["value"])
                    self.answers.recorded.append(_Input(place, event["tick"], answer))
                case "run_ended":
                    self._ended = event
                    if event["state"] == "stopped":
                        self._requests.append(_stop(place, event, moment))

    def _request(self) -> None:
        """Makes the next recorded request if it is due."""
        if not self._requests:
            return
        request = self._requests[0]
        if request.what == "hold":
            self._control.pause_at = (request.at, request.cause)
        elif request.when in ("running", "paused") and self.tick >= request.at:
            self.pause_or_stop()

    def _resume(self) -> None:
        """Ends a pause of the replay at once."""
        self._requests.popleft()
        self._control.resume()
        if self._requests and self._requests[0].when == "paused":
            self._control.stop()


def given_inputs(events: Iterable[WireEvent]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Returns the signs and the answers of a recorded run, in their order. Raises what `RecordedInputs` raises."""
    inputs = RecordedInputs(events)
    gestures = tuple(one.given.label for one in inputs.gestures.recorded)
    return gestures, tuple(one.given for one in inputs.answers.recorded)


class _Recorded(Generic[T]):
    """Gives recorded inputs at their ticks.

    If robot time was stopped during the recorded wait, gives the input at once; otherwise after the recorded ticks.

    Args:
        at_end: called with the question when no recorded input is left.
    """

    def __init__(
        self, run: RecordedInputs, at_end: Callable[[str], None] = lambda question: None
    ) -> None:
        self._run, self._at_end, self._question = run, at_end, ""
        self._has_waited = False
        self.recorded: deque[_Input[T]] = deque()

    def begin(self, question: str) -> None:
        self._question, self._has_waited = question, False

    def poll(self) -> T | Pending:
        run = self._run
        is_due = bool(self.recorded) and self.recorded[0].tick <= run.tick
        is_requested = run.is_requested_before(self.recorded[0].event_index if is_due else math.inf)
        if not self._has_waited:
            self._has_waited = True
            return Pending.PERSON if is_due or is_requested else Pending.TICK
        if is_requested:
            run.pause_or_stop()
            return Pending.PERSON
        if is_due:
            recorded = self.recorded.popleft()
            run.stop_if_it_came_with(recorded.event_index)
            return recorded.given
        if not self.recorded:
            self._at_end(self._question)
        return Pending.TICK

    def cancel(self) -> None:
        return


def _capture(event: WireEvent) -> Capture:
    """Returns the recorded result; records of earlier releases contain only the sign."""
    return Capture(
        _text(event["result"]), event.get("by"), event.get("confidence"), event.get("second", "")
    )


def _text(value: object) -> str:
    if not isinstance(value, str):
        raise TypeError(f"no text: {value!r}")
    return value


def _as_typed(value: object) -> str:
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return format(Decimal(repr(value)), "f") if is_number else _text(value)


class _RecordCursor:
    """State of the recorded run at the current event, and whether robot time was stopped.

    Attributes:
        paused: whether the run was paused.
        awaited_at: the tick at which the run began to wait for an input; None while it did not wait.
        answered_at, answered_index: tick and event index of the last input; the tick is None if ticks passed in the
            wait.
    """

    def __init__(self) -> None:
        self.paused = False
        self.awaited_at: int | None = None
        self.answered_at: int | None = None
        self.answered_index = 0

    def follow(self, place: int, event: WireEvent) -> None:
        kind, tick = event["type"], event["tick"]
        if kind == "run_state":
            self.paused = event["state"] == "paused"
            if not self.paused and self.awaited_at is not None:
                self.awaited_at = tick
        elif kind in ("capture_started", "asked"):
            self.awaited_at = tick
        elif kind == "answered" or (kind == "gesture_result" and event["source"] == "capture"):
            self.answered_at = tick if tick == self.awaited_at else None
            self.answered_index, self.awaited_at = place, None


def _pause(place: int, event: WireEvent, moment: _RecordCursor) -> _Request:
    cause = event.get("cause", "person")
    if cause == "person":
        awaited = event["tick"] == moment.awaited_at
        return _Request("pause", place, event["tick"], when="awaited" if awaited else "running")
    if event.get("n_begun") is None:
        raise PinelError("run_not_repeatable")
    return _Request("hold", place, event["n_begun"], cause)


def _stop(place: int, event: WireEvent, moment: _RecordCursor) -> _Request:
    tick = event.get("params", {}).get("tick")
    if not isinstance(tick, int):
        raise PinelError("run_not_repeatable")
    if moment.paused:
        return _Request("stop", place, tick, when="paused")
    if tick == moment.awaited_at:
        return _Request("stop", place, tick, when="awaited")
    if tick == moment.answered_at:
        return _Request("stop", moment.answered_index, tick, when="answered")
    return _Request("stop", place, tick)
