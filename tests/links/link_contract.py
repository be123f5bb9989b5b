"""What every robot link must keep; subclassed once per backend."""

import math
from collections.abc import Callable

from pinel_desktop.errors import PinelError
from pinel_desktop.execution.clock import TICK_S
from pinel_desktop.robot import STANDSTILL, Pose2D, RobotLink, Twist2D


def _answers_or_is_missing(name: str, is_fine: Callable[[], bool]) -> bool:
    try:
        return is_fine()
    except PinelError as error:
        return (error.code, error.params) == ("sensor_missing", {"sensor": name})


class LinkContract:
    """Subclasses open their link, connected, and say how long a second takes in ticks of `advance`."""

    def open(self) -> RobotLink:
        raise NotImplementedError

    def drive(self, link: RobotLink, twist: Twist2D, seconds: float) -> None:
        for _ in range(round(seconds / TICK_S)):
            link.command(twist)
            link.advance(TICK_S)

    def moved(self, link: RobotLink, start: Pose2D) -> Pose2D:
        return link.read().pose.relative_to(start)

    def test_robot_stands_until_it_is_told_to_move(self) -> None:
        link = self.open()
        start = link.read()
        self.drive(link, STANDSTILL, 0.5)
        assert start.twist == STANDSTILL
        assert self.moved(link, start.pose) == Pose2D()
        link.close()

    def test_positive_velocity_drives_ahead_and_positive_omega_turns_left(self) -> None:
        link = self.open()
        start = link.read().pose
        self.drive(link, Twist2D(0.3, 0.0), 1.0)
        ahead = self.moved(link, start)
        assert 0.2 < ahead.x_m < 0.31
        assert abs(ahead.y_m) < 0.01
        self.drive(link, Twist2D(0.0, 1.0), 1.0)
        assert 0.7 < self.moved(link, start).yaw_rad < 1.05
        link.close()

    def test_twist_is_measured_in_the_robots_frame(self) -> None:
        link = self.open()
        self.drive(link, Twist2D(0.0, 1.0), 1.5)
        self.drive(link, Twist2D(-0.3, 0.0), 1.0)
        measured = link.read().twist
        assert math.isclose(measured.v_mps, -0.3, abs_tol=0.02)
        assert math.isclose(measured.omega_radps, 0.0, abs_tol=0.02)
        link.close()

    def test_commands_beyond_the_robot_are_cut_to_what_it_can_do(self) -> None:
        link = self.open()
        self.drive(link, Twist2D(50.0, 0.0), 1.0)
        assert link.read().twist.v_mps <= 1.2 + 1e-6
        link.close()

    def test_closing_twice_is_fine(self) -> None:
        link = self.open()
        link.close()
        link.close()

    def test_every_sensor_answers_in_its_range_or_says_that_it_is_missing(self) -> None:
        link = self.open()
        sensors = link.sensors
        readings: dict[str, Callable[[], bool]] = {
            "sonar": lambda: all(0.0 <= sensors.sonar(index) <= 5.0 for index in range(16)),
            "lidar": lambda: 0.0 <= sensors.lidar(math.radians(-90)) <= 8.0,
            "bumper": lambda: sensors.bumper() in (True, False),
            "floor": lambda: isinstance(sensors.floor(), str),
            "cell": lambda: isinstance(sensors.cell(), str),
        }
        for name, is_fine in readings.items():
            assert _answers_or_is_missing(name, is_fine), name
        assert link.bumper() in (True, False)
        link.close()
