"""Integral control of the cross-track error. Its state lasts for the whole program."""

_MAX_TRIM_RAD_PER_M = 0.05  # for wheels that differ by 1.5 % on a track of 0.33 m
_MAX_ERROR_M = 0.02  # a larger error means that the robot is stuck or was pushed


class Trim:
    """The turn per metre driven, in rad/m, that compensates wheels of unequal size.

    Unequal wheels turn the robot constantly. Proportional control alone leaves a constant cross-track error, which its
    integral over the distance driven removes. Against wind-up, the trim is bounded. The trim does not change while the
    robot is at rest or more than 2 cm from its line.
    """

    def __init__(self) -> None:
        self.per_m = 0.0

    def integrate(self, across_m: float, driven_m: float, gain: float) -> None:
        """Integrates the cross-track error over the distance driven.

        Args:
            across_m: cross-track error, positive to the left of the line.
            driven_m: distance driven since the previous call.
            gain: integral gain, in rad/m per m².
        """
        if abs(across_m) <= _MAX_ERROR_M:
            learned = self.per_m - gain * across_m * abs(driven_m)
            self.per_m = min(max(learned, -_MAX_TRIM_RAD_PER_M), _MAX_TRIM_RAD_PER_M)
