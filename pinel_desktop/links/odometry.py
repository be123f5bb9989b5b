"""Filter for odometry messages: rejects impossible values, late messages and jumps; estimates missing velocities."""

import math
from collections import deque
from itertools import pairwise
from statistics import median

from pinel_desktop.errors import PinelError
from pinel_desktop.links.reach import CommandedReach
from pinel_desktop.links.transport import Odometry
from pinel_desktop.robot import Pose2D, RobotState, Twist2D, wrap_angle

# After a longer gap, older poses give no velocity, and the robot's clock may have been set.
_PAUSE_S = 0.4
# Limit of a valid coordinate. Squares of smaller numbers cannot overflow.
_FARTHEST_M = 1e5
_MAX_V_MPS, _MAX_OMEGA_RADPS = 20.0, 100.0
# Time between the poses from which a velocity is computed. A shorter time would amplify the
# network's jitter of some ms.
_WINDOW_S = 0.1
_MIN_WINDOW_S = 0.01
_N_GAPS = 5  # number of intervals whose median is the period of the messages


def yaw_of(x: float, y: float, z: float, w: float) -> float:
    """Returns the heading in rad of a quaternion of any length; NaN for a quaternion without direction."""
    if not 1e-6 < x * x + y * y + z * z + w * w < 1e6:
        return math.nan
    return math.atan2(2.0 * (w * z + x * y), w * w + x * x - y * y - z * z)


class OdometryFilter:
    """Turns odometry messages into states. Raises `reference_lost` if the pose jumps.

    A jump is a step or a turn larger than the commanded velocities allow in the time since the previous message.

    Attributes:
        state: the newest state; None before the first valid message.
        arrived_s: arrival time of the newest valid message, by this PC's monotonic clock.
        n_valid: number of valid messages.
        n_invalid: number of skipped messages with impossible values since the newest valid message.
        invalid_s: arrival time of the newest message with impossible values.
        n_late: number of skipped messages with a time stamp before the previous one.
    """

    def __init__(self) -> None:
        self.state: RobotState | None = None
        self.arrived_s = self.invalid_s = -math.inf
        self.n_valid = self.n_invalid = self.n_late = 0
        self._stamp_s: float | None = None
        self._frame: str | None = None
        self._reach = CommandedReach()
        self._arrivals: deque[float] = deque(maxlen=_N_GAPS + 1)
        self._trail: deque[tuple[float, Pose2D]] = (
            deque()
        )  # poses of the last `_WINDOW_S`, each with its arrival time

    @property
    def is_period_known(self) -> bool:
        """Whether enough messages have arrived for a reliable `period_s`."""
        return len(self._arrivals) > _N_GAPS

    @property
    def period_s(self) -> float | None:
        """Median time between recent messages; None before the third message."""
        arrivals = list(self._arrivals)
        if len(arrivals) < 3:
            return None
        return median(after - before for before, after in pairwise(arrivals))

    def robot_s(self, now_s: float) -> float | None:
        """Returns the time by the robot's clock at `now_s`; None without stamps."""
        return None if self._stamp_s is None else self._stamp_s + now_s - self.arrived_s

    def command(self, twist: Twist2D, now_s: float) -> None:
        """Records that the robot is commanded this velocity from `now_s` on."""
        self._reach.command(twist, now_s)

    def add(self, message: Odometry, now_s: float) -> None:
        """Processes a message that arrived at `now_s`.

        Raises PinelError `reference_lost`, `odometry_frame_changed`.
        """
        if not _is_possible(message):
            self.n_invalid += 1
            self.invalid_s = now_s
            return
        if self._is_late(message, now_s):
            self.n_late += 1
            return
        self._require_same_frame(message.frame)
        pose = Pose2D(message.x_m, message.y_m, wrap_angle(message.yaw_rad))
        self._require_no_jump(pose, now_s)
        if now_s - self.arrived_s > _PAUSE_S:
            self._trail.clear()
        twist = self._twist(message, pose, now_s)
        self.n_valid += 1
        self.n_invalid = 0
        self._arrivals.append(now_s)
        self.state, self.arrived_s, self._stamp_s = RobotState(pose, twist), now_s, message.stamp_s

    def _is_late(self, message: Odometry, now_s: float) -> bool:
        """Returns whether a message is out of order.

        If the robot's clock was set back, its messages count again after `_PAUSE_S`.
        """
        stamp, last = message.stamp_s, self._stamp_s
        is_back = stamp is not None and last is not None and stamp < last
        return is_back and now_s - self.arrived_s < _PAUSE_S

    def _require_same_frame(self, frame: str) -> None:
        if self._frame is None:
            self._frame = frame
        elif frame != self._frame:
            raise PinelError("odometry_frame_changed", before=self._frame, now=frame)

    def _require_no_jump(self, pose: Pose2D, now_s: float) -> None:
        if self.state is None:
            return
        step = pose.relative_to(self.state.pose)
        late_s = max((after - before for before, after in pairwise(self._arrivals)), default=0.0)
        if not self._reach.allows(step, self.arrived_s, now_s, late_s):
            raise PinelError("reference_lost", distance=round(math.hypot(step.x_m, step.y_m), 2))

    def _twist(self, message: Odometry, pose: Pose2D, now_s: float) -> Twist2D:
        """Returns the measured velocity, or else the mean velocity of the poses of the last `_WINDOW_S`."""
        if message.v_mps is not None and message.omega_radps is not None:
            return Twist2D(message.v_mps, message.omega_radps)
        trail = self._trail
        while len(trail) > 1 and now_s - trail[1][0] >= _WINDOW_S:
            trail.popleft()
        if not trail or now_s - trail[-1][0] >= _MIN_WINDOW_S:
            trail.append((now_s, pose))
        started_s, begin = trail[0]
        if now_s - started_s < _MIN_WINDOW_S:
            return Twist2D(0.0, 0.0)
        moved, took_s = pose.relative_to(begin), now_s - started_s
        return Twist2D(moved.x_m / took_s, moved.yaw_rad / took_s)


def _is_possible(message: Odometry) -> bool:
    v, omega = message.v_mps or 0.0, message.omega_radps or 0.0
    return (
        abs(message.x_m) < _FARTHEST_M
        and abs(message.y_m) < _FARTHEST_M
        and math.isfinite(message.yaw_rad)
        and abs(v) < _MAX_V_MPS
        and abs(omega) < _MAX_OMEGA_RADPS
        and (message.stamp_s is None or math.isfinite(message.stamp_s))
    )
