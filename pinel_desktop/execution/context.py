"""All that a primitive may touch while a program runs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from random import Random

from pinel_desktop.control import DEFAULT_GAINS, Gains, Trim
from pinel_desktop.events.model import Event
from pinel_desktop.execution.expressions.evaluation import Evaluator
from pinel_desktop.execution.expressions.variables import Variables
from pinel_desktop.execution.failure import RunFailureError
from pinel_desktop.execution.inputs import InputSource
from pinel_desktop.execution.output import Output
from pinel_desktop.robot import STANDSTILL, Pose2D, RobotModel, Sensors, Twist2D

__all__ = ["START", "RunContext", "RunFailureError", "Sources"]

START = Pose2D()


@dataclass(frozen=True, slots=True)
class Sources:
    """Where a run gets from what its program does not say.

    Attributes:
        gestures: results of captures.
        answers: answers to questions.
        sensors: of the link.
        random: the run's own random numbers, made from its seed.
    """

    gestures: InputSource
    answers: InputSource
    sensors: Sensors
    random: Random


@dataclass(slots=True)
class RunContext:
    """State of one run, shared by the executor and its primitives.

    Attributes:
        robot: measures and limits of the robot.
        command_delay_s: how late a commanded velocity takes effect on this link.
        gains: of the controller.
        trim: what the controller has learned of the wheels.
        sources: where the run gets gestures, answers, measurements and random numbers from.
        emit: reports an event.
        observed: whether anybody reads `setpoint` and `done`; otherwise they need not be kept.
        tick: number of the tick that comes next; the first is 1.
        origin: the start frame in the link's.
        pose, twist: newest measurement, in the start frame.
        command: what the robot is told at the next tick; a primitive sets it.
        driving: the velocity that `drive` has set, until the next motion command; None without one.
        max_v_mps, max_omega_radps: limits of the motions to come.
        reference: where the program has brought the robot, ideally: the goal of the last motion. Each motion
            begins there and not at the measured pose, so that errors do not add up.
        reference_lost: whether the robot has moved otherwise since: by `drive`, or by somebody during a pause.
        setpoint: the moving set-point, for the records.
        done: how much of the running motion's amount is done.
        variables: the program's variables.
        output: what the program has said, marked and drawn.
        gesture_result: the last result of a capture, or what a block has set.
        unreported: which of "result" and "pen" a block has set since they were last reported: a loop without motion
            may set them a thousand times a tick, and they are reported once.
        n_evaluated: how many parts of expressions were evaluated, which counts as work.
        waited_s: how much real time has passed while the program waited for a person or a camera.
        n_resumed: how often the run went on after a pause: a motion plans the rest of its way anew.
        evaluator: computes expressions.
    """

    robot: RobotModel
    command_delay_s: float
    sources: Sources
    emit: Callable[[Event], None]
    observed: bool = True
    gains: Gains = DEFAULT_GAINS
    trim: Trim = field(default_factory=Trim)
    tick: int = 1
    origin: Pose2D = START
    pose: Pose2D = START
    twist: Twist2D = STANDSTILL
    command: Twist2D = STANDSTILL
    driving: Twist2D | None = None
    max_v_mps: float = field(init=False)
    max_omega_radps: float = field(init=False)
    reference: Pose2D = START
    reference_lost: bool = False
    setpoint: Pose2D = START
    done: float = 0.0
    variables: Variables = field(default_factory=Variables)
    output: Output = field(init=False)
    gesture_result: str = ""
    unreported: set[str] = field(default_factory=set)
    n_evaluated: int = 0
    waited_s: float = 0.0
    n_resumed: int = 0
    evaluator: Evaluator = field(init=False)

    def __post_init__(self) -> None:
        self.max_v_mps = self.robot.start_v_mps
        self.max_omega_radps = self.robot.start_omega_radps
        self.output = Output(self.emit)
        self.evaluator = Evaluator(self)

    @property
    def sensors(self) -> Sensors:
        """What the robot can sense."""
        return self.sources.sensors

    @property
    def random(self) -> Random:
        """The run's own random numbers."""
        return self.sources.random
