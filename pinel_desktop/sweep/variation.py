"""Robots that differ from run to run: parameters drawn from ranges, as a pure function of the seed."""

import hashlib
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from pinel_desktop.robot import robot_parameters_from
from pinel_desktop.sweep.jobs import Job

_BITS = 53  # of a float's mantissa


class ParameterRange(NamedTuple):
    """The lowest and the highest value of one parameter of the robot."""

    name: str
    low: float
    high: float

    def value(self, seed: int) -> float:
        """Returns the value of a seed.

        The first 53 bits of the SHA-256 of "NAME SEED", as a fraction of 2 to the power of 53, between low and high.
        So each parameter has its own values, and a seed has the same robot in every program and world.
        """
        digest = hashlib.sha256(f"{self.name} {seed}".encode()).digest()
        fraction = (int.from_bytes(digest[:8], "big") >> (64 - _BITS)) / 2.0**_BITS
        return self.low + (self.high - self.low) * fraction


def varied(jobs: Iterable[Job], ranges: Sequence[ParameterRange]) -> Iterator[Job]:
    """Yields the jobs, each with the robot of its seed. Other parameters of its robot stay."""
    for job in jobs:
        values = {one.name: one.value(job.seed) for one in ranges}
        parameters = robot_parameters_from({**job.setting.parameters.changes, **values})
        yield replace(job, setting=replace(job.setting, parameters=parameters))
