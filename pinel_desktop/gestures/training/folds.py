"""Cross-validation folds by source, so that no tested person is in the training data.

Random splits would share people between training and test, and every accuracy would be 1.00. The README of the data
describes the sources.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

# enlarged crops of 64 pixels: used for training, but not representative of a camera's pictures
CROPS = "g7_crops64"
# People at a webcam. The mixed source shows the first person's hand, so it is left out of training.
PEOPLE = ("p1_webcam", "p2_webcam", "p3_webcam", "p4_webcam")
MIXED = "g8_phone_mix"


@dataclass(frozen=True)
class Fold:
    """The tested source, and masks of the n photographs for training and test, (n,) each."""

    source: str
    train: NDArray[np.bool_]
    test: NDArray[np.bool_]


def leave_one_source_out(sources: NDArray[np.str_]) -> Iterator[Fold]:
    """Yields a fold for each source but the crops: test on this source, train on all others."""
    for source in np.unique(sources[sources != CROPS]):
        yield Fold(str(source), sources != source, sources == source)


def strict(sources: NDArray[np.str_]) -> Iterator[Fold]:
    """Yields a fold for each person at a webcam: test on this person, train on pictures that cannot show the person."""
    for person in PEOPLE:
        if (sources == person).any():
            yield Fold(person, ~np.isin(sources, [person, MIXED]), sources == person)
