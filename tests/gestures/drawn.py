"""Hands drawn with circles and polygons: the networks take them for hands, and they show nobody."""

from collections.abc import Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.uint8]
Point = tuple[float, float]

SKIN, SHADE, WALL = (224, 172, 140), (190, 135, 105), (70, 90, 110)
# base and tip of each finger in a picture of 640 pixels
FINGERS: dict[str, tuple[Point, Point]] = {
    "index": ((262, 330), (240, 180)),
    "middle": ((302, 315), (296, 150)),
    "ring": ((342, 318), (352, 165)),
    "little": ((380, 340), (410, 215)),
}
# what the letter L stretches, besides the thumb
LETTER_L = ("index",)
OPEN = tuple(FINGERS)


def drawn_hand(stretched: Sequence[str] = LETTER_L, size: int = 640) -> Picture:
    """A hand with these fingers and the thumb stretched and the others bent, RGB (size, size, 3)."""
    picture = np.full((640, 640, 3), WALL, np.uint8)
    _limb(picture, (318, 640), (318, 500), (52, 56), SKIN)
    cv2.ellipse(picture, (318, 420), (84, 105), 0, 0, 360, SKIN, -1, cv2.LINE_AA)
    for name, (base, tip) in FINGERS.items():
        if name in stretched:
            _limb(picture, base, tip, (23, 17), SHADE)
            _limb(picture, (base[0] - 2, base[1]), (tip[0] - 2, tip[1]), (20, 14), SKIN)
        else:
            _bent(picture, base)
    _limb(picture, (262, 450), (185, 370), (34, 22), SKIN)
    _limb(picture, (185, 370), (160, 320), (22, 16), SKIN)
    soft = cv2.GaussianBlur(picture, (0, 0), 1.5)
    return np.asarray(cv2.resize(soft, (size, size), interpolation=cv2.INTER_AREA), np.uint8)


def on_wall(hand: Picture, width: int, height: int, left: int, top: int) -> Picture:
    """A picture of the wall with the drawn hand at a place."""
    picture = np.full((height, width, 3), WALL, np.uint8)
    picture[top : top + hand.shape[0], left : left + hand.shape[1]] = hand
    return picture


def mirrored(picture: Picture) -> Picture:
    return np.ascontiguousarray(picture[:, ::-1])


def _limb(
    picture: Picture, start: Point, end: Point, radii: tuple[int, int], colour: Sequence[int]
) -> None:
    for share in np.linspace(0, 1, 80):
        at = np.array(start) * (1 - share) + np.array(end) * share
        radius = int(radii[0] * (1 - share) + radii[1] * share)
        cv2.circle(picture, (int(at[0]), int(at[1])), radius, colour, -1, cv2.LINE_AA)


def _bent(picture: Picture, base: Point) -> None:
    x, y = int(base[0]), int(base[1])
    _limb(picture, (x, y), (x, y + 40), (23, 24), SHADE)
    cv2.ellipse(picture, (x, y), (24, 28), 0, 180, 360, SKIN, -1, cv2.LINE_AA)
    cv2.circle(picture, (x, y + 40), 23, SKIN, -1, cv2.LINE_AA)
    cv2.ellipse(picture, (x, y + 40), (23, 24), 0, 0, 180, SHADE, 2, cv2.LINE_AA)
