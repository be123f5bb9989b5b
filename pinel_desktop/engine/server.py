"""The engine process: reads messages, executes one live run at a time, writes its events."""

import gc
import logging
import threading
from typing import Any, BinaryIO

from pinel_desktop.engine.protocol import Message, read_messages, write_message
from pinel_desktop.errors import PinelError
from pinel_desktop.events.model import Event, EventStamp, RunEnded
from pinel_desktop.execution.answers import LiveAnswers
from pinel_desktop.execution.clock import LiveClock, MaxClock
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.executor import RunOptions, execute
from pinel_desktop.execution.gestures import AnsweredGestures
from pinel_desktop.execution.peeking import Questions
from pinel_desktop.links import open_link
from pinel_desktop.program.model import Program
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import RobotLink, setting_from

_log = logging.getLogger(__name__)
_EMPTY_SHA256 = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"
# A run that the end of the pipe interrupts stands still within a second; more would keep a dead app's PC busy.
_STOP_TIMEOUT_S = 3.0


class _LiveRun:
    """One run on a thread of its own."""

    def __init__(self, message: Message, engine: "Engine") -> None:
        self.id = str(message["run"])
        self.control = RunControl()
        self.questions = Questions()
        self.control.breakpoints = frozenset(message.get("breakpoints", ()))
        self.control.set_speed(float(message.get("speed", 1.0)))
        self.control.step = "into" if message.get("paused") else None
        self.gestures = AnsweredGestures()
        self.answers = LiveAnswers()
        self._message, self._engine = message, engine
        self._stamp = EventStamp(self.id)
        self.thread = threading.Thread(target=self._execute, name=f"run-{self.id}", daemon=True)

    def take(self, message: Message) -> None:
        """Does what the app asks of the run."""
        control = self.control
        match message.get("do"):
            case "pause":
                control.pause()
            case "resume":
                control.resume()
            case "stop":
                control.stop()
            case "step":
                control.step_on(message["mode"])
            case "breakpoints":
                control.breakpoints = frozenset(message["blocks"])
            case "look":
                control.looks = frozenset(message["sensors"])
            case "speed":
                control.set_speed(float(message["factor"]))
            case _:
                self._converse(message)

    def _converse(self, message: Message) -> None:
        match message.get("do"):
            case "answer_capture":
                self.gestures.answer(str(message.get("result", "")))
            case "evaluate":
                self._evaluate(message)
            case "answer":
                self.answers.answer(str(message.get("value", "")))

    def _evaluate(self, message: Message) -> None:
        def answer(value: Any, error: PinelError | None) -> None:
            told: Message = {"type": "evaluated", "run": self.id, "question": message["question"]}
            if error is None:
                self._engine.send({**told, "value": value})
            else:
                self._engine.send({**told, "code": error.code, "params": error.params})

        if self.control.pause_requested:
            self.questions.ask(message["expression"], answer)
        else:
            answer(None, PinelError("run_not_paused"))

    def _execute(self) -> None:
        message = self._message
        try:
            setting, seed = setting_from(message.get("setting", {})), int(message.get("seed", 0))
            link = open_link(
                message.get("link", "sim"), world=message["world"], setting=setting, seed=seed
            )
            options = RunOptions(
                observer=self._observe,
                clock=MaxClock() if message.get("pace") == "max" else self._live_clock(link),
                control=self.control,
                questions=self.questions,
                gestures=self.gestures,
                answers=self.answers,
                seed=seed,
                robot=setting.robot,
            )
            program = _program(message)
            gc.freeze()  # searching a long program for garbage would take several ticks
            try:
                execute(program, link, options)
            finally:
                gc.unfreeze()
        except PinelError as error:  # before the first tick: unknown world, faults in the document
            self._observe(0, _never_began(error))
        except OSError:
            _log.warning("nobody reads the events of run %s any more", self.id)

    def _live_clock(self, link: RobotLink) -> LiveClock:
        """A robot knows one speed only; the simulator is as fast as somebody wants it."""
        return LiveClock(speed=lambda: self.control.pace) if link.simulated else LiveClock()

    def _observe(self, tick: int, event: Event) -> None:
        self._engine.send(self._stamp.wire(tick, event))


def _program(message: Message) -> Program:
    reading = read_document(message["document"])
    if reading.program is None:
        raise PinelError("invalid_program", count=len(reading.faults))
    return reading.program


def _never_began(error: PinelError) -> RunEnded:
    return RunEnded(
        state="failed",
        reason=error.code,
        params=error.params,
        block=None,
        n_executed=0,
        duration_s=0.0,
        path_length_m=0.0,
        closing_error_m=0.0,
        pose=None,
        telemetry_sha256=_EMPTY_SHA256,
    )


class Engine:
    """Answers the messages of one pipe with events on another, until the first one ends."""

    def __init__(self, messages: BinaryIO, events: BinaryIO) -> None:
        self._messages, self._events = messages, events
        self._writing = threading.Lock()
        self._live: _LiveRun | None = None

    def send(self, message: Message) -> None:
        """Writes an event; safe from any thread."""
        with self._writing:
            write_message(self._events, message)

    def serve(self) -> None:
        """Works until the messages end; then stops the robot."""
        self.send({"type": "engine_ready"})
        for message in read_messages(self._messages):
            self._handle(message)
        self._stop_and_wait()

    def _handle(self, message: Message) -> None:
        if message.get("do") == "run":
            self._begin(message)
            return
        live = self._live
        if live is None or message.get("run") != live.id:
            return  # the run ended while the message was on its way
        live.take(message)

    def _begin(self, message: Message) -> None:
        # The app asks for one run at a time; should an old one still be winding down, it goes first.
        self._stop_and_wait()
        self._live = _LiveRun(message, self)
        self._live.thread.start()

    def _stop_and_wait(self) -> None:
        if self._live is not None:
            self._live.control.stop()
            self._live.thread.join(_STOP_TIMEOUT_S)
