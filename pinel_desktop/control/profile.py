"""S-curve motion profile: the set-points of a motion from standstill to standstill."""

import math
from functools import lru_cache


@lru_cache(maxsize=256)  # programs repeat motions, and a class repeats programs
def s_curve(
    distance: float, speed: float, acceleration: float, smoothing_s: float, dt_s: float
) -> tuple[float, ...]:
    """Returns set-points every `dt_s` seconds, from 0 to `distance`, which may be negative.

    The profile is a trapezoid of velocity, averaged over a window of `smoothing_s`. Its acceleration is continuous, and
    its jerk is at most `2 * acceleration / smoothing_s`. Method: L. Biagiotti and C. Melchiorri, "FIR filters for
    online trajectory planning", 2012. `distance`, `speed` and `acceleration` share one unit of length or angle.

    Returns:
        Positions at 0, dt, 2 dt, ...; the first is 0 and the last is exactly `distance`.
    """
    length = abs(distance)
    if length == 0.0:
        return (0.0,)
    ramp_s = min(speed / acceleration, math.sqrt(length / acceleration))
    peak = acceleration * ramp_s
    cruise_s = length / peak - ramp_s
    duration = 2.0 * ramp_s + cruise_s + smoothing_s
    trapezoid = _Trapezoid(acceleration, peak, ramp_s, cruise_s, length)
    ticks = math.ceil(duration / dt_s - 1e-9)
    sign = math.copysign(1.0, distance)
    points = [sign * trapezoid.smoothed(k * dt_s, smoothing_s) for k in range(ticks)]
    return (*points, distance)


class _Trapezoid:
    """Velocity profile: accelerates for `ramp_s`, drives at `peak` for `cruise_s`, decelerates for `ramp_s`."""

    def __init__(
        self, acceleration: float, peak: float, ramp_s: float, cruise_s: float, length: float
    ) -> None:
        self.acceleration, self.peak, self.ramp_s = acceleration, peak, ramp_s
        self.slow_from_s = ramp_s + cruise_s
        self.end_s = self.slow_from_s + ramp_s
        self.length = length
        self._ramp_integral = acceleration * ramp_s**3 / 6.0
        self._ramp_length = acceleration * ramp_s**2 / 2.0
        self._cruise_integral = (
            self._ramp_integral + self._ramp_length * cruise_s + peak * cruise_s**2 / 2.0
        )

    def smoothed(self, t: float, window_s: float) -> float:
        """Returns the position at `t`, averaged over the `window_s` before `t`."""
        return (self._integral(t) - self._integral(t - window_s)) / window_s

    def _integral(self, t: float) -> float:
        """Returns the integral of the position from the start to `t`."""
        if t <= 0.0:
            return 0.0
        if t < self.ramp_s:
            return self.acceleration * t**3 / 6.0
        if t < self.slow_from_s:
            tau = t - self.ramp_s
            return self._ramp_integral + self._ramp_length * tau + self.peak * tau**2 / 2.0
        tau = min(t, self.end_s) - self.slow_from_s
        done = self.length - self._ramp_length
        slowing = done * tau + self.peak * tau**2 / 2.0 - self.acceleration * tau**3 / 6.0
        return self._cruise_integral + slowing + self.length * max(t - self.end_s, 0.0)
