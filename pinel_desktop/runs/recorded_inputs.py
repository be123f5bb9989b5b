"""The inputs of a recorded run, given again at the same ticks and between the same commands."""

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
    """A pause or stop that was requested by a person or a breakpoint.

    Attributes:
        event_index: its place among the recorded events; of one that came together with an input, the input's.
        at: the tick; for `hold`, how many commands had begun.
        when: what the run did at that tick. While it `awaited` a person, when one had just `answered`, or while it was
            `paused`, robot time stood still.
    """

    what: Literal["pause", "hold", "stop"]
    event_index: float
    at: int
    cause: PauseCause = "person"
    when: Literal["running", "paused", "awaited", "answered"] = "running"


T = TypeVar("T")


class _Input(NamedTuple, Generic[T]):
    """A recorded result or answer, and the tick at which it was given."""

    event_index: int
    tick: int
    given: T


class RecordedInputs:
    """Inputs and requests of a recorded run, for its replay.

    Args:
        events: of the recorded run in their order, as they are on the wire; telemetry may be missing.
        until_tick: where the record breaks off, so that the replay stops there too; None where it does not.

    Raises PinelError `run_not_repeatable` for a record that does not tell when the run was stopped or held,
    `run_damaged` where an event is none.
    """

    is_live = False

    def __init__(self, events: Iterable[WireEvent], until_tick: int | None = None) -> None:
        self.gestures = _Recorded[Capture](self)
        self.answers = _Recorded[str](self, self._answer_missing)
        self.tick = 0
        self._control = RunControl()
        self._is_paused = False  # the robot still comes to rest then, which takes ticks
        self._requests: deque[_Request] = deque()
        self._ended: WireEvent = {}
        try:
            self._read(events)
        except (KeyError, TypeError, AttributeError) as error:
            raise PinelError("run_damaged", part="events") from error
        if until_tick is not None:
            self._requests.append(_Request("stop", math.inf, until_tick))

    def attach(self, control: RunControl) -> Callable[[int, Event], None]:
        """Gives recorded requests to `control`; returns what must observe the replay."""
        self._control = control
        if self._ended.get("state") == "stopped":
            control.stop_reason = self._ended["reason"]
        return self._observe

    def is_requested_before(self, place: float) -> bool:
        """Whether a pause or stop is due that came while the program waited, before the event at that place."""
        if not self._requests:
            return False
        request = self._requests[0]
        return request.when == "awaited" and self.tick >= request.at and request.event_index < place

    def stop_if_it_came_with(self, place: int) -> None:
        """Makes the request to stop that came in the same moment as the input at that place."""
        if (
            self._requests
            and self._requests[0].when == "answered"
            and self._requests[0].event_index == place
        ):
            self._control.stop()

    def pause_or_stop(self) -> None:
        """Makes the request that is due."""
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
        """Makes the next request, if its time has come."""
        if not self._requests:
            return
        request = self._requests[0]
        if request.what == "hold":
            self._control.pause_at = (request.at, request.cause)
        elif request.when in ("running", "paused") and self.tick >= request.at:
            self.pause_or_stop()

    def _resume(self) -> None:
        """After a pause, which is over at once."""
        self._requests.popleft()
        self._control.resume()
        if self._requests and self._requests[0].when == "paused":
            self._control.stop()


class _Recorded(Generic[T]):
    """Gives recorded inputs at their ticks: at once where robot time stood still, else when its ticks have passed.

    Args:
        at_end: called with the question where the record has no input left.
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
    """The whole result; records of earlier releases tell the sign only."""
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
    """Where the recorded run stood, and whether robot time stood still there.

    Attributes:
        paused: whether it was paused.
        awaited_at: the tick since which it waited for an input; None while it did not.
        answered_at, answered_index: of the last input, where no tick had passed while it was awaited.
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
