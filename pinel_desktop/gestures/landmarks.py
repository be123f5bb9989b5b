"""Landmarks of one hand in a crop: MediaPipe's landmark network, with the activations of an inner layer as output."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures.networks import Network
from pinel_desktop.gestures.regions import Region, cut

Array = NDArray[np.float64]

SIZE = 224


@dataclass(frozen=True)
class Hand:
    """One hand, as the output of the landmark network. Landmark numbers as in MediaPipe: 0 wrist, 4 thumb tip, ... 20.

    points: (21, 3), pixels of the picture; z in the same unit, towards the camera negative, 0 at the wrist.
    in_crop: (21, 3), pixels of the crop, which is 224 wide. world: (21, 3), metres, in the frame of the crop.
    activations: (14, 14, 112), activations of the network's inner layer over the crop.
    presence: 0..1, whether the crop shows a hand. chirality: 0..1, whether the hand in the crop is a right hand.
    mirrored: whether the crop was mirrored to make a left hand a right hand.
    """

    points: Array
    in_crop: Array
    world: Array
    activations: NDArray[np.float32]
    presence: float
    chirality: float
    mirrored: bool

    @property
    def handedness(self) -> Literal["left", "right"]:
        """Which hand of the person it is, in a picture that is not mirrored."""
        return "left" if self.mirrored else "right"

    @property
    def box(self) -> tuple[float, float, float, float]:
        """Bounding box of the landmarks: left, top, right, bottom, in pixels of the picture."""
        low, high = self.points[:, :2].min(0), self.points[:, :2].max(0)
        return (float(low[0]), float(low[1]), float(high[0]), float(high[1]))


class LandmarkNetwork:
    """Computes landmarks in a region of a picture. `presence` shows whether the region has a hand at all."""

    def __init__(self, network: Network) -> None:
        self._network = network

    def __call__(
        self, picture: NDArray[np.uint8], region: Region, *, mirrored: bool = False
    ) -> Hand:
        to_picture = region.to_picture(SIZE, mirrored=mirrored)
        landmarks, presence, chirality, world, activations = self._network(
            cut(picture, to_picture, SIZE)
        )
        in_crop = landmarks.reshape(21, 3).astype(np.float64)
        flat = in_crop[:, :2] @ to_picture[:, :2].T + to_picture[:, 2]
        return Hand(
            points=np.column_stack([flat, in_crop[:, 2] * region.side / SIZE]),
            in_crop=in_crop,
            world=world.reshape(21, 3).astype(np.float64),
            activations=activations,
            presence=float(presence[0]),
            chirality=float(chirality[0]),
            mirrored=mirrored,
        )
