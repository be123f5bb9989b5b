"""The state of a run that primitives may use."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from random import Random

from pinel_desktop.control import DEFAULT_GAINS, Gains, Trim
from pinel_desktop.control.goal import GOALS, Goals
from pinel_desktop.events.model import Event
from pinel_desktop.execution.expressions.evaluation import Evaluator
from pinel_desktop.execution.expressions.variables import Variables
from pinel_desktop.execution.failure import RunFailureError
from pinel_desktop.execution.inputs import NO_NUMBER, Capture, InputSource
from pinel_desktop.execution.output import Output
from pinel_desktop.execution.places import MarkedPlaces
from pinel_desktop.execution.semantics import CURRENT
from pinel_desktop.robot import STANDSTILL, Pose2D, RobotModel, Sensors, Twist2D

__all__ = ["START", "RunContext", "RunFailureError", "Sources"]

START = Pose2D()


@dataclass(frozen=True, slots=True)
class Sources:
    """External inputs of a run.

    Attributes:
        gestures: results of captures.
        answers: answers to questions.
        sensors: sensors of the link.
        random: the run's random generator, seeded with its seed.
    """

    gestures: InputSource[Capture]
    answers: InputSource[str]
    sensors: Sensors
    random: Random


@dataclass(slots=True)
class RunContext:
    """State of one run, shared by the executor and its primitives.

    Attributes:
        robot: dimensions and limits of the robot.
        command_delay_s: delay (s) of a commanded velocity on this link.
        gains: gains of the controller.
        goals: goal tolerances and settle times of motions.
        trim: wheel correction that the controller estimates.
        semantics: version of the meaning of commands and sensors (`semantics.py`).
        sources: gestures, answers, measurements and random numbers.
        emit: reports an event.
        observed: whether `setpoint` and `done` are read; otherwise primitives need not set them.
        tick: number of the next tick; the first is 1.
        origin: pose of the start frame in the link's frame.
        pose, twist: newest measurement, in the start frame.
        command: velocity for the next tick, set by primitives.
        driving: velocity set by `drive`, until the next motion command; None without one.
        max_v_mps, max_omega_radps: velocity limits of the next motions.
        reference: ideal pose, the goal of the last motion. Each motion starts there and not at the measured pose,
            so that errors do not accumulate.
        reference_lost: whether the robot has moved otherwise since: by `drive`, or by hand during a pause.
        setpoint: the moving set-point, for the records.
        done: completed part of the running motion's amount, in its unit.
        variables: the program's variables.
        marked: the marks by place.
        output: texts, marks, beeps, questions and pen of the program.
        gesture_result: the last result of a capture, or the value set by a block.
        number_shown: the last number that a hand showed; `NO_NUMBER` without one.
        unreported: "result" and "pen" if set since the last report. They are reported once a tick: a loop without
            motion may set them a thousand times a tick.
        n_evaluated: evaluated parts of expressions, which count as work.
        waited_s: real time spent waiting for a person or a camera.
        n_resumed: number of resumes after a pause; a motion then plans its remainder again.
        evaluator: evaluates expressions.
    """

    robot: RobotModel
    command_delay_s: float
    sources: Sources
    emit: Callable[[Event], None]
    observed: bool = True
    gains: Gains = DEFAULT_GAINS
    goals: Goals = GOALS
    trim: Trim = field(default_factory=Trim)
    semantics: int = CURRENT
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
    marked: MarkedPlaces = field(default_factory=MarkedPlaces)
    output: Output = field(init=False)
    gesture_result: str = ""
    number_shown: int = NO_NUMBER
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

    def adapt_to(self, delay_s: float) -> None:
        """Sets the delay (s) of commands on this link; the longer the delay, the lower the controller's gains."""
        self.command_delay_s, self.gains = delay_s, self.gains.for_delay(delay_s)

    @property
    def sensors(self) -> Sensors:
        """The sensors of the link."""
        return self.sources.sensors

    @property
    def random(self) -> Random:
        """The run's random generator."""
        return self.sources.random
