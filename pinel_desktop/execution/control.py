"""What other threads ask of a run: pause, go on, step, stop, hold at blocks, another speed, values, answers."""

from collections.abc import Callable
from queue import SimpleQueue
from typing import Any, Literal, NamedTuple

from pinel_desktop.errors import PinelError
from pinel_desktop.events.model import PauseCause
from pinel_desktop.execution.inputs import LiveInputs

StepMode = Literal["into", "over", "out"]
LEAST_SPEED, GREATEST_SPEED = 0.1, 10.0

# takes a value, or why there is none
Reply = Callable[[Any, PinelError | None], None]


class EvaluationRequest(NamedTuple):
    """An expression as document data, and who wants its value."""

    expression: Any
    reply: Reply


class RunControl:
    """Requests to a run, made on any thread and read by the run once a tick or before each command.

    Stop wins over everything, also over a pause.

    Attributes:
        breakpoints: ids of the blocks before which the run pauses.
        step: how far the run goes on before it pauses again; None when it just runs.
        hold_at: the run pauses when so many commands have begun, for the cause given; None when it does not.
        subscriptions: rings of sensors whose measurements are to be reported: "sonar", "lidar".
        speed: robot time divided by wall time, in the simulator; a real robot has one speed only.
        evaluations: expressions to evaluate while the run is paused.
        inputs: take what people answer to captures and questions.
    """

    def __init__(self) -> None:
        self.stop_requested = False
        self.pause_requested = False
        self.breakpoints: frozenset[str] = frozenset()
        self.step: StepMode | None = None
        self.hold_at: tuple[int, PauseCause] | None = None
        self.subscriptions: frozenset[str] = frozenset()
        self.speed = 1.0
        self.evaluations: SimpleQueue[EvaluationRequest] = SimpleQueue()
        self.inputs = LiveInputs()

    @property
    def pace(self) -> float:
        """`speed`, but at least 1 once the robot is to stop: that must not happen in slow motion."""
        return max(self.speed, 1.0) if self.stop_requested else self.speed

    def stop(self) -> None:
        self.stop_requested = True

    def pause(self) -> None:
        self.pause_requested = True

    def resume(self) -> None:
        self.step = None
        self.pause_requested = False

    def step_on(self, mode: StepMode) -> None:
        """Goes on to the next block: into functions, over them, or out of the one that runs."""
        self.step = mode
        self.pause_requested = False

    def set_speed(self, speed: float) -> None:
        """Slow motion or fast forward; a value outside of LEAST_SPEED to GREATEST_SPEED is clamped."""
        self.speed = min(max(speed, LEAST_SPEED), GREATEST_SPEED)

    def evaluate(self, expression: Any, reply: Reply) -> None:
        """Has the run's own thread evaluate an expression; replies `run_not_paused` at once where it runs."""
        if self.pause_requested:
            self.evaluations.put(EvaluationRequest(expression, reply))
        else:
            reply(None, PinelError("run_not_paused"))
