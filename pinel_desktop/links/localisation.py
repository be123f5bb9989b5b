"""What a robot's own localisation says: impossible poses and poses of another frame are refused, late ones skipped."""

import math
import threading
from collections.abc import Sequence
from typing import NamedTuple

from pinel_desktop.errors import PinelError
from pinel_desktop.links.transport import Localised
from pinel_desktop.robot import Pose2D, wrap_angle

# one sigma of a pose whose message states none
SIGMA_M, SIGMA_RAD = 0.05, math.radians(3.0)
_MIN_SIGMA, _MAX_SIGMA = 0.001, 3.0
_FARTHEST_M = 1e4
_MAX_AGE_S = 1.0  # of a pose on its arrival; a larger difference is that of two clocks


class LocalisedPose(NamedTuple):
    """A pose in the frame of the map.

    Attributes:
        sigma_m, sigma_rad: one sigma of each coordinate and of the heading.
        at_s: when the robot was there, by this PC's monotonic clock.
    """

    pose: Pose2D
    sigma_m: float
    sigma_rad: float
    at_s: float


class Localisation:
    """The newest pose of one robot's localisation; thread-safe.

    Args:
        frame: name of the frame of the map. Names count without a leading slash.
    """

    def __init__(self, frame: str) -> None:
        self._frame = frame.strip("/")
        self._lock = threading.Lock()
        self._stamp_s: float | None = None
        self._newest: LocalisedPose | PinelError | None = None

    def add(self, found: Localised, now_s: float, robot_now_s: float | None) -> None:
        """Handles a pose that arrived at `now_s`.

        Args:
            robot_now_s: the time by the robot's clock; None if unknown.
        """
        with self._lock:
            if self._is_late(found.stamp_s):
                return
            self._stamp_s = found.stamp_s
            self._newest = self._problem(found) or LocalisedPose(
                Pose2D(found.x_m, found.y_m, wrap_angle(found.yaw_rad)),
                _bounded(found.sigma_m, SIGMA_M),
                _bounded(found.sigma_rad, SIGMA_RAD),
                now_s - _age_s(found.stamp_s, robot_now_s),
            )

    def pop(self) -> LocalisedPose | PinelError | None:
        """Returns the newest pose once, or why it does not count; None without a new one."""
        with self._lock:
            newest, self._newest = self._newest, None
            return newest

    def _is_late(self, stamp_s: float | None) -> bool:
        """Returns whether a pose is out of order; a robot's clock that was set back far starts again."""
        if stamp_s is None or self._stamp_s is None:
            return False
        return 0.0 < self._stamp_s - stamp_s < _MAX_AGE_S

    def _problem(self, found: Localised) -> PinelError | None:
        if found.frame.strip("/") != self._frame:
            return PinelError(
                "localisation_other_frame", found=found.frame or "?", wanted=self._frame
            )
        is_near = abs(found.x_m) < _FARTHEST_M and abs(found.y_m) < _FARTHEST_M  # refuses NaN, too
        if is_near and math.isfinite(found.yaw_rad):
            return None
        return PinelError("localisation_invalid")


def sigmas_of(variances: Sequence[float] | None) -> tuple[float | None, float | None]:
    """Returns one sigma of the coordinates and of the heading; None where a message states none.

    Args:
        variances: of x, y and heading; None without any.
    """
    if variances is None:
        return None, None
    x, y, yaw = variances
    return _root(max(x, y)), _root(yaw)


def _root(variance: float) -> float | None:
    return math.sqrt(variance) if 0.0 < variance < math.inf else None


def _bounded(sigma: float | None, default: float) -> float:
    return default if sigma is None else min(max(sigma, _MIN_SIGMA), _MAX_SIGMA)


def _age_s(stamp_s: float | None, robot_now_s: float | None) -> float:
    """Returns how old a pose is on its arrival; 0 where the clocks do not tell."""
    if stamp_s is None or robot_now_s is None:
        return 0.0
    age_s = robot_now_s - stamp_s
    return age_s if 0.0 < age_s < _MAX_AGE_S else 0.0
