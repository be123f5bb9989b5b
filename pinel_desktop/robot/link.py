"""The protocol of all robot links: read the state, command a velocity."""

from collections.abc import Callable
from typing import NamedTuple, Protocol

from pinel_desktop.robot.geometry import Pose2D, Twist2D
from pinel_desktop.robot.sensors import Sensors


class RobotState(NamedTuple):
    """State of a robot at one time.

    Attributes:
        pose: estimated pose in the link's frame (world or odometry).
        twist: measured velocity in the robot's frame.
        true_pose: true pose in the link's frame; None on real robots, which only have the estimate.
    """

    pose: Pose2D
    twist: Twist2D
    true_pose: Pose2D | None = None


class RobotLink(Protocol):
    """A robot that can be driven; `links/` has one implementation per backend.

    Every link stops its robot when commands expire, when odometry messages stop, and when the link is closed.

    Attributes:
        simulated: True if time passes only in `advance`.
        command_delay_s: mean time from `command` until the velocity takes effect, in seconds; final once connected.
        slips: True if wheels roll more or less far than commanded; the controller then uses integral control.
        sensors: sensors of the robot; its pose, twist and bumper are also read without them.
    """

    simulated: bool
    command_delay_s: float
    slips: bool
    sensors: Sensors

    def connect(self, cancelled: Callable[[], bool] = lambda: False) -> None:
        """Connects with the robot. Polls `cancelled()`, and returns early without a connection once it is true.

        Raises PinelError with the cause and its remedy.
        """

    def read(self) -> RobotState:
        """Returns the newest state. Raises PinelError `link_lost` if the robot no longer reports."""
        ...

    def bumper(self) -> bool:
        """Returns whether the robot touches an obstacle, for telemetry; False without a bumper."""
        ...

    def movable_boxes(self) -> dict[int, Pose2D]:
        """Returns the poses of movable boxes in the world's frame, by index in the world's list; empty if unknown."""
        ...

    def command(self, twist: Twist2D) -> None:
        """Sets the velocity, limited to the robot's maximum."""

    def advance(self, dt_s: float) -> None:
        """Advances a simulator by `dt_s` seconds; does nothing for a real robot."""

    def close(self) -> None:
        """Stops the robot and releases all resources; safe to call twice."""
