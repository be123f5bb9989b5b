"""What a controller learns of the wheels while it drives: the I of the PID, kept over the whole program."""

_MOST_PER_M = 0.05  # rad/m: wheels that differ by 1.5 % on a track of 0.33 m
_FARTHEST_M = (
    0.02  # beyond, somebody pushed the robot, or it is stuck: nothing is learned of the wheels
)


class Trim:
    """By how much the robot is to turn for each metre that it drives, so that it drives straight.

    Wheels of unequal size turn the robot a little all the time. Proportional control alone would let it run beside its
    line, just as far as it takes to steer against that. The integral of the way beside the line finds the turn that is
    missing. It is bounded and stands still when the robot is far from the line or does not drive, so that it cannot
    wind up.
    """

    def __init__(self) -> None:
        self.per_m = 0.0

    def learn(self, across_m: float, way_m: float, gain: float) -> None:
        """Takes in that the robot was `across_m` to the left of its line over `way_m`; `gain` in rad/m per m²."""
        if abs(across_m) <= _FARTHEST_M:
            learned = self.per_m - gain * across_m * abs(way_m)
            self.per_m = min(max(learned, -_MOST_PER_M), _MOST_PER_M)
