"""All that a primitive may touch while a program runs."""

from collections.abc import Callable
from dataclasses import dataclass

from pinel_desktop.errors import PinelError
from pinel_desktop.events.model import Event
from pinel_desktop.execution.gestures import GestureSource
from pinel_desktop.robot import STANDSTILL, Pose2D, RobotModel, Twist2D


class RunFailureError(PinelError):
    """The run cannot go on: its code is the run's reason."""


START = Pose2D()


@dataclass(slots=True)
class RunContext:
    """State of one run, shared by the executor and its primitives.

    Attributes:
        robot: measures and limits of the robot.
        command_delay_s: how late a commanded velocity takes effect on this link.
        gestures: where gesture results come from.
        emit: reports an event.
        observed: whether anybody reads `setpoint` and `done`; otherwise they need not be kept.
        tick: number of the tick that comes next; the first is 1.
        pose, twist: newest measurement, in the start frame.
        command: what the robot is told at the next tick; a primitive sets it.
        reference: where the program has brought the robot, ideally: the goal of the last motion. Each motion
            begins there and not at the measured pose, so that errors do not add up.
        setpoint: the moving set-point, for the records.
        done: how much of the running motion's amount is done.
        gesture_result: the last result of a capture, or what a block has set.
        result_unreported: whether a block has set the result since it was last reported: a loop without motion
            may set it a thousand times a tick, and is reported once.
        n_evaluated: how many parts of expressions were evaluated, which counts as work.
        n_resumed: how often the run went on after a pause: a motion plans the rest of its way anew.
        moved_by_hand: whether somebody moved the robot during the last pause.
    """

    robot: RobotModel
    command_delay_s: float
    gestures: GestureSource
    emit: Callable[[Event], None]
    observed: bool = True
    tick: int = 1
    pose: Pose2D = START
    twist: Twist2D = STANDSTILL
    command: Twist2D = STANDSTILL
    reference: Pose2D = START
    setpoint: Pose2D = START
    done: float = 0.0
    gesture_result: str = ""
    result_unreported: bool = False
    n_evaluated: int = 0
    n_resumed: int = 0
    moved_by_hand: bool = False
