"""What a backend of real robots implements: it carries velocities to the robot and readings from it.

`links/real.py` does the rest, the same for all: repeats commands, lets stale ones expire, watches the odometry and
keeps the limits.
"""

from collections.abc import Callable
from typing import NamedTuple, Protocol

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import Sensors, Twist2D

Cancelled = Callable[[], bool]


class Odometry(NamedTuple):
    """One message of a robot about itself, as it came: it may hold anything.

    Attributes:
        x_m, y_m, yaw_rad: pose in the robot's odometry frame.
        v_mps, omega_radps: velocity in the robot's own frame; None where it tells its pose only.
        stamp_s: the robot's own time; None if it has none.
        frame: name of the odometry frame; "" if it has none.
    """

    x_m: float
    y_m: float
    yaw_rad: float
    v_mps: float | None
    omega_radps: float | None
    stamp_s: float | None = None
    frame: str = ""


class Receiver(Protocol):
    """Takes what comes from the robot, on any thread, without waiting."""

    def on_odometry(self, odometry: Odometry) -> None:
        """A message about pose and velocity. Impossible values are told from possible ones by the receiver."""

    def on_battery(self, level: float) -> None:
        """Charge of the battery, from 0 to 1."""

    def on_holder(self, name: str | None) -> None:
        """Who else drives the robot now; None for nobody."""

    def on_problem(self, problem: PinelError) -> None:
        """The robot must not be driven any more: the next reading raises `problem`, and zeros are sent."""


class Transport(Protocol):
    """One connection with one robot. Made without side effects; opened once, closed once.

    Attributes:
        sensors: the sensors besides those of the robot's own state; which ones there are is known once it is open.
    """

    sensors: Sensors

    def open(self, receiver: Receiver, cancelled: Cancelled) -> None:
        """Connects; returns when the robot can hear commands, or when `cancelled()`, which is polled every 50 ms.

        Raises PinelError that says what is missing and what to do, after a few seconds at most.
        """

    def listen(self, receiver: Receiver, cancelled: Cancelled) -> None:
        """In place of `open`: connects to hear only. Nothing is published, and nobody takes the robot for driven.

        Raises as `open` does. Afterwards nothing is sent.
        """

    def send(self, twist: Twist2D) -> None:
        """Sends a velocity, at once and without waiting. Called on the link's sending thread only."""

    def bumper(self) -> bool:
        """True while the robot reports that it touches something."""
        ...

    def close(self) -> None:
        """Ends the connection; called after the last zeros were sent, and also if `open` failed."""
