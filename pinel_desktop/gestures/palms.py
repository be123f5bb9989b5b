"""Palm detection in a picture: MediaPipe's palm detector."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures.networks import Network
from pinel_desktop.gestures.opencv import cv2
from pinel_desktop.gestures.regions import Region, around_palm

Array = NDArray[np.float64]

_SIZE = 192
_WRIST, _MIDDLE_BASE = 0, 2  # among the seven key points
_MAX_PALMS = 4
_MAX_OVERLAP = 0.3


@dataclass(frozen=True)
class Palm:
    """A detected palm: score 0..1, box (centre x, centre y, width, height) and 7 key points (7, 2), in pixels."""

    score: float
    box: Array
    points: Array

    @property
    def centre(self) -> Array:
        """Midpoint between the wrist and the base of the middle finger."""
        middle: Array = (self.points[_WRIST] + self.points[_MIDDLE_BASE]) / 2
        return middle

    @property
    def region(self) -> Region:
        return around_palm(self.points[_WRIST], self.points[_MIDDLE_BASE], self.box)


class PalmDetector:
    """Detects the palms in a picture."""

    def __init__(self, network: Network) -> None:
        self._network = network
        self._anchors = _anchors()

    def __call__(
        self, picture: NDArray[np.uint8], *, padding: float, min_score: float
    ) -> list[Palm]:
        """Returns at most 4 palms of an RGB picture, the best first.

        Args:
            padding: 1 scales the longer side to the network's 192 pixels. 2 scales it to half of them, which detects
                hands that fill the picture.
            min_score: score threshold, 0..1.
        """
        height, width = picture.shape[:2]
        scale = _SIZE / (max(height, width) * padding)
        boxes, logits = self._network(_letterboxed(picture, scale))
        score = 1 / (1 + np.exp(-np.clip(logits[:, 0].astype(np.float64), -100, 100)))
        likely = np.flatnonzero(score >= min_score)
        likely = likely[np.argsort(-score[likely], kind="stable")]
        found: list[Palm] = []
        for i in likely:
            palm = _palm(float(score[i]), boxes[i], self._anchors[i], scale, (width, height))
            if all(_overlap(palm.box, other.box) <= _MAX_OVERLAP for other in found):
                found.append(palm)
            if len(found) == _MAX_PALMS:
                break
        return found


def _anchors() -> Array:
    """Returns the anchors of the outputs in pixels, (2016, 2): 2 per cell of a 24 x 24 grid, 6 per cell of 12 x 12."""
    grids = []
    for cells, n_each in ((24, 2), (12, 6)):
        along = (np.arange(cells) + 0.5) * _SIZE / cells
        x, y = np.meshgrid(along, along)
        grids.append(np.repeat(np.column_stack([x.ravel(), y.ravel()]), n_each, axis=0))
    return np.concatenate(grids)


def _letterboxed(picture: NDArray[np.uint8], scale: float) -> NDArray[np.uint8]:
    """Returns the scaled picture in the middle of a black square of 192 pixels."""
    height, width = picture.shape[:2]
    if (
        scale < 0.5
    ):  # average whole pixels first, because bilinear sampling alone would skip fine structure
        factor = int(1 / scale)
        size = (max(width // factor, 1), max(height // factor, 1))
        picture = np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_AREA), np.uint8)
    across, down = scale * width / picture.shape[1], scale * height / picture.shape[0]
    corner = (_SIZE - scale * width) / 2, (_SIZE - scale * height) / 2
    matrix = np.array([[across, 0, corner[0]], [0, down, corner[1]]])
    return np.asarray(cv2.warpAffine(picture, matrix, (_SIZE, _SIZE)), np.uint8)


def _palm(
    score: float, raw: NDArray[np.float32], anchor: Array, scale: float, size: tuple[int, int]
) -> Palm:
    """Converts one row of the network's output to a palm in pixels of the picture.

    The row has centre, width and height, and key points in pixels of the network; points are relative to the anchor.
    """
    pairs = raw.reshape(9, 2).astype(np.float64)
    places = np.concatenate([pairs[:1], pairs[2:]]) + anchor
    in_picture = (places - _SIZE / 2) / scale + np.array(size) / 2
    return Palm(score, np.concatenate([in_picture[0], pairs[1] / scale]), in_picture[1:])


def _overlap(a: Array, b: Array) -> float:
    """Returns the intersection over union of two boxes."""
    low = np.maximum(a[:2] - a[2:] / 2, b[:2] - b[2:] / 2)
    high = np.minimum(a[:2] + a[2:] / 2, b[:2] + b[2:] / 2)
    both = float(np.prod(np.maximum(high - low, 0)))
    return both / (float(np.prod(a[2:]) + np.prod(b[2:])) - both + 1e-9)
