"""Stateless noise: a pure function of (seed, channel, tick, index).

With a stateful generator, reading one sensor would change the numbers of another sensor. SplitMix64 (G. L. Steele et
al., "Fast splittable pseudorandom number generators", 2014) computes its n-th number directly. Each channel has its
own starting state.
"""

import math

_MASK = (1 << 64) - 1
_STEP = 0x9E3779B97F4A7C15
_INDICES = 1 << 10  # beams and sonars of one tick
# sum of four uniform numbers from 0 to 65535: its mean, and the factor to standard deviation 1
_MEAN = 2 * 65535
_SCALE = math.sqrt(3.0 / (65536.0**2 - 1.0))


class Noise:
    """The noise of one channel, such as a wheel or the sonars, for one seed."""

    def __init__(self, seed: int, channel: int) -> None:
        self._state = _mix((_mix(seed & _MASK) + channel * _STEP) & _MASK)

    def normal(self, tick: int, index: int = 0) -> float:
        """Returns a number with mean 0 and standard deviation 1, within ±3.47.

        The number is a scaled sum of four uniform integers (Irwin-Hall distribution), because a true normal deviate
        would not be bit-identical on every processor.
        """
        bits = _mix((self._state + (tick * _INDICES + index) * _STEP) & _MASK)
        total = (bits & 0xFFFF) + (bits >> 16 & 0xFFFF) + (bits >> 32 & 0xFFFF) + (bits >> 48)
        return (total - _MEAN) * _SCALE


def _mix(bits: int) -> int:
    bits = (bits ^ bits >> 30) * 0xBF58476D1CE4E5B9 & _MASK
    bits = (bits ^ bits >> 27) * 0x94D049BB133111EB & _MASK
    return bits ^ bits >> 31
