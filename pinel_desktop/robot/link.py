"""The protocol of all robots: read the state, command a velocity."""

from collections.abc import Callable
from typing import NamedTuple, Protocol

from pinel_desktop.robot.geometry import Pose2D, Twist2D
from pinel_desktop.robot.sensors import Sensors


class RobotState(NamedTuple):
    """One reading of a robot.

    Attributes:
        pose: estimated pose in the link's frame (world or odometry).
        twist: measured velocity in the robot's frame.
        true_pose: exact pose in the same frame; None where only the estimate is known, as on real robots.
    """

    pose: Pose2D
    twist: Twist2D
    true_pose: Pose2D | None = None


class RobotLink(Protocol):
    """A robot that can be driven; `links/` has one implementation per backend.

    Every link stops its robot when commands go stale, when its odometry goes silent and when it is closed.

    Attributes:
        simulated: True if time passes only in `advance`.
        command_delay_s: mean time from `command` until the velocity takes effect, in seconds; final once connected.
        slips: True if wheels roll more or less far than commanded; the controller then uses integral control.
        sensors: the sensors besides those of the robot's own state.
    """

    simulated: bool
    command_delay_s: float
    slips: bool
    sensors: Sensors

    def connect(self, cancelled: Callable[[], bool] = lambda: False) -> None:
        """Makes the robot ready; returns early and not ready when `cancelled()`, which it polls, is true.

        Raises PinelError that says what is missing and what to do.
        """

    def read(self) -> RobotState:
        """The latest state. Raises PinelError `link_lost` when the robot no longer reports."""
        ...

    def bumper(self) -> bool:
        """True while the robot touches something, for telemetry; False if it has no bumper."""
        ...

    def movable_boxes(self) -> dict[int, Pose2D]:
        """Poses of movable boxes in the world's frame, by index in the world's list; empty if unknown."""
        ...

    def command(self, twist: Twist2D) -> None:
        """Sets the velocity from now on, limited to the robot's maximum."""

    def advance(self, dt_s: float) -> None:
        """Advances a simulator by `dt_s` seconds; does nothing for a real robot."""

    def close(self) -> None:
        """Stops the robot and releases all resources; safe to call twice."""
