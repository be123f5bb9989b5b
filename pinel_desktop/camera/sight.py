"""The signs in the frames of a camera, in their order."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.camera.frames import Shot
from pinel_desktop.gestures.classifier import Reading
from pinel_desktop.gestures.recognition import Recogniser


@dataclass(frozen=True, slots=True)
class SeenSign:
    """A hand in a frame and what it shows.

    Attributes:
        points: 21 landmarks (x, y) in px of the frame.
        handedness: which hand of the person it is.
        reading: the sign that it shows.
        is_taught: whether the likeliest sign is one that the class taught.
    """

    points: NDArray[np.float32]
    handedness: Literal["left", "right"]
    reading: Reading
    is_taught: bool = False


class Sight:
    """Looks at the frames of one camera."""

    def __init__(self, recogniser: Recogniser) -> None:
        self._recogniser = recogniser

    def look(self, shot: Shot) -> list[SeenSign]:
        """The hands of the next frame, at most two."""
        if shot.hands is not None:
            return [
                SeenSign(
                    hand.points,
                    "left" if hand.is_left else "right",
                    self._recogniser.classifier.read(hand.features, self._recogniser.doubt),
                )
                for hand in shot.hands
            ]
        return [
            SeenSign(seen.hand.points[:, :2].astype(np.float32), seen.hand.handedness, seen.reading)
            for seen in self._recogniser.follow(shot.picture)
        ]

    def begin_anew(self) -> None:
        """Forgets the hands that it follows: the next frame comes from elsewhere."""
        self._recogniser.forget()
