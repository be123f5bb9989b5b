"""How photographs are divided for an honest figure: whoever is tested was never seen in training.

Splits at random share people, and every figure is 1.00 then. What the sources hold is told in the README of the data.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

# crops of 64 pixels, blown up: learnt from, but no measure for a camera's pictures
CROPS = "g7_crops64"
# people at a webcam. The mixed source shows the hand of the first of them, so it is left out of training with them.
PEOPLE = ("p1_webcam", "p2_webcam", "p3_webcam", "p4_webcam")
MIXED = "g8_phone_mix"


@dataclass(frozen=True)
class Fold:
    """One source to test, and which of n photographs are learnt from and tested, (n,) each."""

    source: str
    train: NDArray[np.bool_]
    test: NDArray[np.bool_]


def leave_one_source_out(sources: NDArray[np.str_]) -> Iterator[Fold]:
    """Each source but the crops is tested once, by what was learnt from all others."""
    for source in np.unique(sources[sources != CROPS]):
        yield Fold(str(source), sources != source, sources == source)


def strict(sources: NDArray[np.str_]) -> Iterator[Fold]:
    """Each person at a webcam is tested by what was learnt from pictures that cannot show that person."""
    for person in PEOPLE:
        if (sources == person).any():
            yield Fold(person, ~np.isin(sources, [person, MIXED]), sources == person)
