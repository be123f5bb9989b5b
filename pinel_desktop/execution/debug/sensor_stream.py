"""Reports the poses of pushed boxes and the measurements of subscribed sensors."""

from collections.abc import Callable

from pinel_desktop.errors import PinelError
from pinel_desktop.events.model import BoxesMoved, Ranges
from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.control import RunControl
from pinel_desktop.robot import Pose2D, RobotLink

_PAUSE_TICKS = 3
_DIGITS, _STEP = 4, 1e-4  # a tenth of a millimetre


class SensorStream:
    """Reports at most ten times a second of robot time; for runs with an observer."""

    def __init__(self, context: RunContext, link: RobotLink, control: RunControl) -> None:
        self._context, self._link, self._control = context, link, control
        self._poses: dict[int, Pose2D] = link.movable_boxes()
        self._subscribed: frozenset[str] = frozenset()

    def report(self) -> None:
        """Called at every tick; reports when due."""
        if self._context.tick % _PAUSE_TICKS:
            return
        if self._poses:
            self.report_boxes()
        if self._control.subscriptions:
            self._report_ranges()

    def report_new_subscriptions(self) -> None:
        """Called while robot time is stopped; reports new subscriptions once."""
        if self._subscribed != self._control.subscriptions:
            self._report_ranges()

    def report_boxes(self) -> None:
        """Reports the boxes that have moved since the last report."""
        poses = self._link.movable_boxes()
        moved = {
            str(index): (
                round(pose.x_m, _DIGITS),
                round(pose.y_m, _DIGITS),
                round(pose.yaw_rad, _DIGITS),
            )
            for index, pose in poses.items()
            if not _close(pose, self._poses[index])
        }
        if moved:
            self._poses = {**self._poses, **{int(index): poses[int(index)] for index in moved}}
            self._context.emit(BoxesMoved(moved))

    def _report_ranges(self) -> None:
        self._subscribed = subscriptions = self._control.subscriptions
        sensors = self._context.sensors
        self._context.emit(
            Ranges(
                _rounded(sensors.sonars) if "sonar" in subscriptions else None,
                _rounded(sensors.scan) if "lidar" in subscriptions else None,
            )
        )


def _close(pose: Pose2D, other: Pose2D) -> bool:
    return max(abs(a - b) for a, b in zip(pose, other, strict=True)) < _STEP / 2.0


def _rounded(measure: Callable[[], list[float]]) -> list[float] | None:
    """Measurements of a ring of sensors (m); None if the robot has no such ring."""
    try:
        return [round(distance, _DIGITS) for distance in measure()]
    except PinelError:
        return None
