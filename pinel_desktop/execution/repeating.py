"""Running a recorded run again: what people did then is done at the same ticks, in between the same commands."""

from collections import deque
from collections.abc import Iterable, Mapping
from decimal import Decimal
from typing import Any, Literal, NamedTuple

from pinel_desktop.errors import PinelError
from pinel_desktop.events.model import Event, PauseCause, RunState, Telemetry
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.failure import RunFailureError

WireEvent = Mapping[str, Any]


class _Wish(NamedTuple):
    """What somebody, or a breakpoint, asked for: at a tick, or when so many commands had begun."""

    what: Literal["pause", "hold", "stop"]
    at: int
    cause: PauseCause = "person"
    while_paused: bool = False


class Repeater:
    """Observer, gestures, answers and control of one run that is a repetition.

    Args:
        events: of the recorded run in their order, as they are on the wire; telemetry may be missing.
        until_tick: where the record breaks off, so that the repetition stops there too; None where it does not.

    Raises PinelError `run_not_repeatable` for a record that does not tell when somebody stopped or held the run,
    `run_damaged` where an event is none.
    """

    def __init__(self, events: Iterable[WireEvent], until_tick: int | None = None) -> None:
        self.control = RunControl()
        self.gestures, self.answers = _Captures(self), _Answers(self)
        self.tick = 0
        self._is_paused = False  # the robot still comes to rest then, which takes ticks
        self._wishes: deque[_Wish] = deque()
        self._ended: WireEvent = {}
        try:
            self._take_in(events)
        except (KeyError, TypeError, AttributeError) as error:
            raise PinelError("run_damaged", part="events") from error
        if until_tick is not None:
            self._wishes.append(_Wish("stop", until_tick))

    @property
    def reason(self) -> str | None:
        """Why the recorded run ended."""
        return self._ended.get("reason")

    def observe(self, tick: int, event: Event) -> None:
        """To be called with every event of the repetition."""
        if type(event) is Telemetry:
            self.tick = tick
            if self._wishes and not self._is_paused:
                self._wish()
        elif type(event) is RunState:
            self._is_paused = event.state == "paused"
            if self._is_paused:
                self._go_on()
            else:
                self._wish()

    def _take_in(self, events: Iterable[WireEvent]) -> None:
        paused = False
        for event in events:
            match event["type"]:
                case "run_state":
                    paused = event["state"] == "paused"
                    if paused:
                        self._wishes.append(_pause(event))
                case "gesture_result" if event["source"] == "capture":
                    self.gestures.recorded.append((event["tick"], _text(event["result"])))
                case "answered":
                    self.answers.recorded.append((event["tick"], _as_typed(event["value"])))
                case "run_ended":
                    self._ended = event
                    if event["state"] == "stopped":
                        self._wishes.append(_Wish("stop", _stop_tick(event), "person", paused))

    def _wish(self) -> None:
        """Asks for what comes next, if its time has come."""
        if not self._wishes:
            return
        wish = self._wishes[0]
        if wish.what == "hold":
            self.control.hold_at = (wish.at, wish.cause)
        elif self.tick >= wish.at:
            if wish.what == "stop":
                self.control.stop()
            else:
                self.control.pause()

    def _go_on(self) -> None:
        """After a pause, which is over at once."""
        self._wishes.popleft()
        self.control.resume()
        if self._wishes and self._wishes[0].while_paused:
            self.control.stop()


class _Captures:
    """Gives the recorded results at their ticks."""

    def __init__(self, run: Repeater) -> None:
        self._run = run
        self.recorded: deque[tuple[int, str]] = deque()

    def begin(self) -> None:
        return

    def poll(self) -> str | None:
        if self.recorded and self.recorded[0][0] <= self._run.tick:
            return self.recorded.popleft()[1]
        return None

    def cancel(self) -> None:
        return


class _Answers:
    """Gives the recorded answers at their ticks, as they might have been typed."""

    def __init__(self, run: Repeater) -> None:
        self._run, self._question = run, ""
        self.recorded: deque[tuple[int, str]] = deque()

    def begin(self, question: str) -> None:
        self._question = question

    def poll(self) -> str | None:
        if self.recorded and self.recorded[0][0] <= self._run.tick:
            return self.recorded.popleft()[1]
        if not self.recorded and self._run.reason == "answer_missing":
            raise RunFailureError("answer_missing", question=self._question)
        return None

    def cancel(self) -> None:
        return


def _text(value: object) -> str:
    if not isinstance(value, str):
        raise TypeError(f"no text: {value!r}")
    return value


def _as_typed(value: object) -> str:
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return format(Decimal(repr(value)), "f") if is_number else _text(value)


def _pause(event: WireEvent) -> _Wish:
    cause = event.get("cause", "person")
    if cause == "person":
        return _Wish("pause", event["tick"])
    if event.get("n_begun") is None:
        raise PinelError("run_not_repeatable")
    return _Wish("hold", event["n_begun"], cause)


def _stop_tick(event: WireEvent) -> int:
    tick = event.get("params", {}).get("tick")
    if not isinstance(tick, int):
        raise PinelError("run_not_repeatable")
    return tick
