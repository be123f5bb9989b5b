"""Square crops of a picture, rotated so that the hand points upwards.

Frame of a picture: pixels, x to the right, y downwards, origin at the corner of the first pixel. Shift, scale and the
choice of landmarks come from MediaPipe's hand graphs, for which the networks were trained.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures.opencv import cv2

Array = NDArray[np.float64]

_PALM_SHIFT, _PALM_SCALE = -0.5, 2.6
_HAND_SHIFT, _HAND_SCALE = -0.1, 2.0
WRIST, INDEX_BASE, MIDDLE_BASE, RING_BASE = 0, 5, 9, 13
# wrist, thumb without its tip, base and middle joint of each finger: move little if fingers bend
_STABLE = [0, 1, 2, 3, 5, 6, 9, 10, 13, 14, 17, 18]


@dataclass(frozen=True)
class Region:
    """A square with centre (x, y) and sides of `side` pixels, rotated clockwise by `angle_rad` radians."""

    x: float
    y: float
    side: float
    angle_rad: float

    def to_picture(self, size: int, *, mirrored: bool) -> Array:
        """Returns the affine matrix (2, 3) from pixels of the crop, `size` pixels wide, to pixels of the picture."""
        cos, sin = math.cos(self.angle_rad), math.sin(self.angle_rad)
        turned = np.array([[cos, -sin], [sin, cos]]) * self.side / size
        if mirrored:
            turned[:, 0] *= -1
        middle = np.full(2, size / 2)
        return np.column_stack([turned, np.array([self.x, self.y]) - turned @ middle])

    @property
    def box(self) -> tuple[float, float, float, float]:
        """Left, top, right and bottom of the unrotated square of the same size."""
        half = self.side / 2
        return (self.x - half, self.y - half, self.x + half, self.y + half)


def cut(picture: NDArray[np.uint8], to_picture: Array, size: int) -> NDArray[np.uint8]:
    """Returns the crop (size, size, 3) that `Region.to_picture` describes; black outside the picture."""
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    crop: NDArray[np.uint8] = np.asarray(
        cv2.warpAffine(picture, to_picture, (size, size), flags=flags), np.uint8
    )
    return crop


def around_palm(wrist: Array, middle_base: Array, box: Array) -> Region:
    """Returns the crop for a detected palm; `box` has its centre x and y, width and height, in px."""
    turn = _upright(middle_base - wrist)
    up = np.array([math.sin(turn), -math.cos(turn)])
    x, y = box[:2] - _PALM_SHIFT * box[3] * up
    return Region(float(x), float(y), float(box[2:].max()) * _PALM_SCALE, turn)


def around_hand(points: Array) -> Region:
    """Returns the crop for known landmarks (21, 2 or 3), from a first pass or from the frame before."""
    flat = points[:, :2]
    towards = (flat[INDEX_BASE] + flat[RING_BASE]) / 4 + flat[MIDDLE_BASE] / 2
    turn = _upright(towards - flat[WRIST])
    right, down = (
        np.array([math.cos(turn), math.sin(turn)]),
        np.array([-math.sin(turn), math.cos(turn)]),
    )
    along = flat[_STABLE] @ np.column_stack([right, down])
    low, high = along.min(0), along.max(0)
    centre = (low + high) / 2 + [0, _HAND_SHIFT * (high[1] - low[1])]
    x, y = centre[0] * right + centre[1] * down
    return Region(float(x), float(y), float((high - low).max()) * _HAND_SCALE, turn)


def _upright(direction: Array) -> float:
    """Returns the clockwise angle from the vertical to a direction, in radians."""
    return math.atan2(float(direction[0]), float(-direction[1]))
