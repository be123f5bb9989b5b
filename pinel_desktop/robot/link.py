"""What the rest of the program knows about a robot: read its state, command a velocity."""

from typing import NamedTuple, Protocol

from pinel_desktop.robot.geometry import Pose2D, Twist2D
from pinel_desktop.robot.sensors import Sensors


class RobotState(NamedTuple):
    """One reading of a robot.

    Attributes:
        pose: where the robot believes it is, in the link's own frame (world or odometry).
        twist: measured velocity in the robot's frame.
        true_pose: where it really is, where that is known (a simulator); else None.
    """

    pose: Pose2D
    twist: Twist2D
    true_pose: Pose2D | None = None


class RobotLink(Protocol):
    """A robot that can be driven; one implementation per backend in `links/`.

    Every link stops its robot when commands go stale, when its odometry goes silent and when it is closed.

    Attributes:
        simulated: True when time stands still between calls of `advance`.
        command_delay_s: how much later than `command` a velocity takes effect on the average, in seconds.
        slips: whether wheels roll more or less far than they are told, which a controller can learn.
        sensors: what the robot can sense besides its own state.
    """

    simulated: bool
    command_delay_s: float
    slips: bool
    sensors: Sensors

    def connect(self) -> None:
        """Makes the robot ready. Raises PinelError with what is missing and what to do."""

    def read(self) -> RobotState:
        """The newest state. Raises PinelError `link_lost` when the robot has gone silent."""
        ...

    def bumper(self) -> bool:
        """True while the robot touches something, for those who watch; False where the robot cannot tell."""
        ...

    def things(self) -> dict[int, Pose2D]:
        """Where movable boxes are, by their place in the world's list and in its frame; empty where nobody knows."""
        ...

    def command(self, twist: Twist2D) -> None:
        """Sets the velocity from now on, limited to what the robot can do."""

    def advance(self, dt_s: float) -> None:
        """Lets `dt_s` seconds pass in a simulator; a real robot needs nothing done."""

    def close(self) -> None:
        """Stops the robot and gives everything back; safe to call twice."""
