"""The transport protocol of real robots: a backend carries velocities to the robot and readings from it.

`links/real.py` does the rest for all backends: repeats commands, expires them, checks the odometry, applies the limits.
"""

from collections.abc import Callable
from typing import NamedTuple, Protocol

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import Sensors, Twist2D

Cancelled = Callable[[], bool]


class Odometry(NamedTuple):
    """One unchecked odometry message of a robot.

    Attributes:
        x_m, y_m, yaw_rad: pose in the robot's odometry frame.
        v_mps, omega_radps: velocity in the robot's own frame; None if the robot reports its pose only.
        stamp_s: time stamp by the robot's clock; None without one.
        frame: name of the odometry frame; "" without one.
    """

    x_m: float
    y_m: float
    yaw_rad: float
    v_mps: float | None
    omega_radps: float | None
    stamp_s: float | None = None
    frame: str = ""


class Localised(NamedTuple):
    """One unchecked pose of a robot's own localisation.

    Attributes:
        x_m, y_m, yaw_rad: pose in the frame of a map.
        sigma_m, sigma_rad: one sigma of each coordinate and of the heading; None if the message states none.
        stamp_s: time stamp by the robot's clock; None without one.
        frame: name of the frame; "" without one.
    """

    x_m: float
    y_m: float
    yaw_rad: float
    sigma_m: float | None
    sigma_rad: float | None
    stamp_s: float | None
    frame: str


class Receiver(Protocol):
    """Handles the messages of the robot, on any thread, without waiting."""

    def on_odometry(self, odometry: Odometry) -> None:
        """Handles an odometry message, and rejects impossible values."""

    def on_localised(self, localised: Localised) -> None:
        """Handles a pose of the robot's own localisation. Only a robot whose profile names its topic has one."""

    def on_battery(self, level: float) -> None:
        """Handles the charge of the battery, from 0 to 1; a value outside means that it is unknown."""

    def on_holder(self, name: str | None) -> None:
        """Handles the name of another program that drives the robot; None if there is none."""

    def on_problem(self, problem: PinelError) -> None:
        """Stops the robot for good: zeros are sent, and the next `read` raises `problem`."""


class Transport(Protocol):
    """One connection with one robot. Its construction has no side effects; it is opened once and closed once.

    Attributes:
        sensors: sensors of the robot; the available ones are known once the connection is open.
    """

    sensors: Sensors

    def open(self, receiver: Receiver, cancelled: Cancelled) -> None:
        """Connects. Returns once the robot can receive commands, or once `cancelled()` is true (polled every 50 ms).

        If it cannot connect within its time-out, raises PinelError with the cause and its remedy.
        """

    def listen(self, receiver: Receiver, cancelled: Cancelled) -> None:
        """Connects to receive only, in place of `open`. Publishes nothing, so other programs see no driver.

        Raises the errors of `open`. Afterwards `send` sends nothing.
        """

    def send(self, twist: Twist2D) -> None:
        """Sends a velocity without waiting. Called on the thread of `VelocityPublisher` only."""

    def bumper(self) -> bool:
        """Returns whether the robot reports that it touches an obstacle."""
        ...

    def close(self) -> None:
        """Ends the connection. Called after the last zeros were sent, and also if `open` failed."""
