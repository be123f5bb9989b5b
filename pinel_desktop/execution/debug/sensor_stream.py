"""What those who watch see around the robot: boxes that were pushed, and on demand what its sensors measure."""

from collections.abc import Callable

from pinel_desktop.errors import PinelError
from pinel_desktop.events.model import Ranges, Things
from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.control import RunControl
from pinel_desktop.robot import Pose2D, RobotLink

_PAUSE_TICKS = 3
_DIGITS, _STEP = 4, 1e-4  # a tenth of a millimetre


class Surroundings:
    """Reports at most ten times a second of robot time; for runs that somebody watches."""

    def __init__(self, context: RunContext, link: RobotLink, control: RunControl) -> None:
        self._context, self._link, self._control = context, link, control
        self._poses: dict[int, Pose2D] = link.things()
        self._looked: frozenset[str] = frozenset()

    def look(self) -> None:
        """At every tick: reports when it is time."""
        if self._context.tick % _PAUSE_TICKS:
            return
        if self._poses:
            self.report_things()
        if self._control.looks:
            self._report_ranges()

    def look_while_paused(self) -> None:
        """Nothing moves: what was not asked for before is reported once."""
        if self._looked != self._control.looks:
            self._report_ranges()

    def report_things(self) -> None:
        """The boxes that have moved since the last time, where there are any."""
        poses = self._link.things()
        moved = {
            str(index): [round(value, _DIGITS) for value in pose]
            for index, pose in poses.items()
            if not _close(pose, self._poses[index])
        }
        if moved:
            self._poses = {**self._poses, **{int(index): poses[int(index)] for index in moved}}
            self._context.emit(Things(moved))

    def _report_ranges(self) -> None:
        self._looked = wanted = self._control.looks
        sensors = self._context.sensors
        self._context.emit(
            Ranges(
                _rounded(sensors.sonars) if "sonar" in wanted else None,
                _rounded(sensors.scan) if "lidar" in wanted else None,
            )
        )


def _close(pose: Pose2D, other: Pose2D) -> bool:
    return max(abs(a - b) for a, b in zip(pose, other, strict=True)) < _STEP / 2.0


def _rounded(measure: Callable[[], list[float]]) -> list[float] | None:
    """What a ring of sensors measures; None where the robot has none."""
    try:
        return [round(distance, _DIGITS) for distance in measure()]
    except PinelError:
        return None
