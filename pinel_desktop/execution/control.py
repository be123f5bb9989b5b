"""Requests of other threads to a run: pause, resume, step, stop, breakpoints, speed, evaluation, answers."""

import time
from collections.abc import Callable
from queue import Empty, SimpleQueue
from typing import Any, Literal, NamedTuple

from pinel_desktop.errors import PinelError
from pinel_desktop.events.model import PauseCause
from pinel_desktop.execution.inputs import LiveInputs

StepMode = Literal["into", "over", "out"]
MIN_SPEED, MAX_SPEED = 0.1, 10.0
# with a tick and the transmission to the robot, the robot stops within 0.3 s
KEEPALIVE_TIMEOUT_S = 0.2
# reasons of runs that were stopped
BY_PERSON, CALLER_LEFT = "stopped_by_person", "caller_left"

# receives a value, or the error
Reply = Callable[[Any, PinelError | None], None]


class EvaluationRequest(NamedTuple):
    """An expression as document data, and the receiver of its value."""

    expression: Any
    reply: Reply


class RunControl:
    """Requests to a run, made on any thread and read by the run at every tick and before each command.

    Stop has priority over all others, pause included.

    Attributes:
        breakpoints: ids of the blocks before which the run pauses.
        step: mode of the step after which the run pauses; None without a step.
        pause_at: number of started commands at which the run pauses, and the cause; None for no such pause.
        subscriptions: sensor rings whose measurements are reported: "sonar", "lidar".
        speed: robot time divided by wall time; simulator only.
        evaluations: expressions to evaluate while the run is paused.
        inputs: receive people's answers to captures and questions.
        is_open: whether the run waits at its end for more commands.
        stop_reason: code of the reason of a stopped run.
    """

    def __init__(self) -> None:
        self.stop_requested = False
        self.stop_reason = BY_PERSON
        self.pause_requested = False
        self.breakpoints: frozenset[str] = frozenset()
        self.step: StepMode | None = None
        self.pause_at: tuple[int, PauseCause] | None = None
        self.subscriptions: frozenset[str] = frozenset()
        self.speed = 1.0
        self.evaluations: SimpleQueue[EvaluationRequest] = SimpleQueue()
        self.inputs = LiveInputs()
        self.is_open = False
        self._more: SimpleQueue[list[Any]] = SimpleQueue()
        self._last_keepalive_s: float | None = None

    def record_keepalive(self) -> None:
        """Records a keepalive of the app.

        From the first keepalive on, a real robot is stopped while keepalives are missing.
        """
        self._last_keepalive_s = time.monotonic()

    @property
    def keepalive_expired(self) -> bool:
        """Whether the app has sent keepalives, but none within `KEEPALIVE_TIMEOUT_S`."""
        last_s = self._last_keepalive_s
        return last_s is not None and time.monotonic() - last_s > KEEPALIVE_TIMEOUT_S

    @property
    def pace(self) -> float:
        """`speed`, but at least 1 after Stop: stopping must not happen in slow motion."""
        return max(self.speed, 1.0) if self.stop_requested else self.speed

    def stop(self, reason: str | None = None) -> None:
        """Ends the run; the first reason counts."""
        if reason is not None and not self.stop_requested:
            self.stop_reason = reason
        self.stop_requested = True

    def pause(self) -> None:
        self.pause_requested = True

    def resume(self) -> None:
        self.step = None
        self.pause_requested = False

    def step_on(self, mode: StepMode) -> None:
        """Runs to the next block: into function calls, over them, or out of the running function."""
        self.step = mode
        self.pause_requested = False

    def set_speed(self, speed: float) -> None:
        """Sets the speed factor, clamped to MIN_SPEED..MAX_SPEED."""
        self.speed = min(max(speed, MIN_SPEED), MAX_SPEED)

    def append(self, commands: list[Any]) -> None:
        """Appends commands, as document data, to the program; makes the run an open one."""
        self.is_open = True
        if commands:
            self._more.put(commands)

    def finish(self) -> None:
        """Lets an open run end when all of its commands are done."""
        self.is_open = False

    def next_commands(self) -> list[Any] | None:
        """Returns the oldest appended commands that were not fetched yet; None without any."""
        try:
            return self._more.get_nowait()
        except Empty:
            return None

    def evaluate(self, expression: Any, reply: Reply) -> None:
        """Queues an expression for evaluation on the run's thread; replies `run_not_paused` at once unless paused."""
        if self.pause_requested:
            self.evaluations.put(EvaluationRequest(expression, reply))
        else:
            reply(None, PinelError("run_not_paused"))
