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
    """A recorded result or answer, and its tick: of the run, or of its wait for another run."""

    event_index: int
    tick: int
    given: T


class RecordedInputs:
    """Inputs and requests of a recorded run, for its replay, or its inputs alone for another run.

    Another robot or a changed program asks at other ticks: it gets each input after as many ticks of waiting as in the
    record, without the record's pauses and its stop. Past the last input its run fails.

    Args:
        events: events of the recorded run in their order, in wire format; telemetry may be missing. `input_events` are
            enough for another run.
        until_tick: the tick at which the replay stops; None for no limit.
        is_replay: whether the recorded run is replayed; else its inputs are for another run.

    Raises PinelError `run_not_repeatable` if the record lacks the tick of a stop or the command of a pause,
    `run_damaged` if an event is malformed.
    """

    is_live = False

    def __init__(
        self,
        events: Iterable[WireEvent],
        until_tick: int | None = None,
        *,
        is_replay: bool = True,
    ) -> None:
        self.is_replay = is_replay
        self.gestures = _Recorded[Capture](self, self._gesture_missing)
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

    def _gesture_missing(self, _question: str) -> None:
        if not self.is_replay:
            raise RunFailureError("no_more_gestures")

    def _answer_missing(self, question: str) -> None:
        if not self.is_replay or self._ended.get("reason") == "answer_missing":
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
                case "run_state" if event["state"] == "paused" and self.is_replay:
                    self._requests.append(_pause(place, event, moment))
                case "gesture_result" if event["source"] == "capture":
                    due = self._due(event, moment)
                    self.gestures.recorded.append(_Input(place, due, capture_of(event)))
                case "answered":
                    answer = typed_answer(event["value"])
                    self.answers.recorded.append(_Input(place, self._due(event, moment), answer))
                case "run_ended" if self.is_replay:
                    self._ended = event
                    if event["state"] == "stopped":
                        self._requests.append(_stop(place, event, moment))

    def _due(self, event: WireEvent, moment: "_RecordCursor") -> int:
        """Returns the tick of an input; for another run, counted from the begin of its wait."""
        return int(event["tick"]) if self.is_replay else moment.n_waited

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


_INPUT_EVENTS = ("capture_started", "gesture_result", "asked", "answered", "run_state")


def input_events(events: Iterable[WireEvent]) -> list[WireEvent]:
    """Returns the events of a recorded run that say which inputs it got, and how long it waited for each."""
    return [event for event in events if event["type"] in _INPUT_EVENTS]


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
        self._has_waited, self._since = False, 0
        self.recorded: deque[_Input[T]] = deque()

    def begin(self, question: str) -> None:
        self._question, self._has_waited = question, False
        self._since = 0 if self._run.is_replay else self._run.tick

    def poll(self) -> T | Pending:
        run = self._run
        is_due = bool(self.recorded) and self.recorded[0].tick <= run.tick - self._since
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


def capture_of(event: WireEvent) -> Capture:
    """Returns the recorded result; records of earlier releases contain only the sign."""
    return Capture(
        _text(event["result"]), event.get("by"), event.get("confidence"), event.get("second", "")
    )


def _text(value: object) -> str:
    if not isinstance(value, str):
        raise TypeError(f"no text: {value!r}")
    return value


def typed_answer(value: object) -> str:
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return format(Decimal(repr(value)), "f") if is_number else _text(value)


class _RecordCursor:
    """State of the recorded run at the current event, and whether robot time was stopped.

    Attributes:
        paused: whether the run was paused.
        awaited_at: the tick at which the run began to wait for an input; None while it did not wait.
        answered_at, answered_index: tick and event index of the last input; the tick is None if ticks passed in the
            wait.
        n_waited: how many ticks the wait for the last input took.
    """

    def __init__(self) -> None:
        self.paused = False
        self.awaited_at: int | None = None
        self.answered_at: int | None = None
        self.answered_index = self.n_waited = 0

    def follow(self, place: int, event: WireEvent) -> None:
        kind, tick = event["type"], event["tick"]
        if kind == "run_state":
            self.paused = event["state"] == "paused"
            if not self.paused and self.awaited_at is not None:
                self.awaited_at = tick
        elif kind in ("capture_started", "asked"):
            self.awaited_at = tick
        elif kind == "answered" or (kind == "gesture_result" and event["source"] == "capture"):
            self.n_waited = 0 if self.awaited_at is None else tick - self.awaited_at
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
