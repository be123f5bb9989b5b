"""Noise that depends on nothing but what it is asked for: a function of (seed, channel, tick, index).

A generator with a state would give other numbers when somebody else reads a sensor first. Here each number is worked
out from its place: SplitMix64 (G. L. Steele and others, "Fast splittable pseudorandom number generators", 2014), whose
n-th number needs no other, for each channel from a place of its own.
"""

import math

_MASK = (1 << 64) - 1
_STEP = 0x9E3779B97F4A7C15
_INDICES = 1 << 10  # beams and sonars of one tick
# The sum of four numbers drawn evenly from 0 to 65535: mean, and what makes its standard deviation 1.
_MEAN = 2 * 65535
_SCALE = math.sqrt(3.0 / (65536.0**2 - 1.0))


class Noise:
    """The noise of one channel, such as a wheel or the sonars, in the run of that seed."""

    def __init__(self, seed: int, channel: int) -> None:
        self._place = _mixed((_mixed(seed & _MASK) + channel * _STEP) & _MASK)

    def normal(self, tick: int, index: int = 0) -> float:
        """A number of mean 0 and standard deviation 1, never beyond 3.47.

        The sum of four even ones instead of a true normal deviate: whole numbers only, and so the same to the bit on
        every processor.
        """
        bits = _mixed((self._place + (tick * _INDICES + index) * _STEP) & _MASK)
        total = (bits & 0xFFFF) + (bits >> 16 & 0xFFFF) + (bits >> 32 & 0xFFFF) + (bits >> 48)
        return (total - _MEAN) * _SCALE


def _mixed(bits: int) -> int:
    bits = (bits ^ bits >> 30) * 0xBF58476D1CE4E5B9 & _MASK
    bits = (bits ^ bits >> 27) * 0x94D049BB133111EB & _MASK
    return bits ^ bits >> 31
