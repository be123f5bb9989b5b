"""Finds the printed markers in a picture."""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.camera.overhead.markers import FLOOR_MARKERS, ROBOT_MARKER
from pinel_desktop.gestures.opencv import cv2
from pinel_desktop.gestures.pictures import Picture

# corners of a marker in px, shape (4, 2): top left as printed, then clockwise in the picture
Corners = NDArray[np.float64]
Line = tuple[NDArray[np.float64], NDArray[np.float64]]  # a place on it, and its direction
_KNOWN = frozenset((*FLOOR_MARKERS, ROBOT_MARKER))
_MIN_SIDE_PX = 10.0
_REACH_PX = 3.0  # from the rough place of an edge to its true place
_ACROSS = np.arange(-_REACH_PX, _REACH_PX + 0.01, 0.25)
_PARALLEL = 0.2


def find_markers(picture: Picture) -> dict[int, Corners]:
    """Returns the corners of the known markers by number; a number that is seen twice counts as not seen."""
    grey = np.asarray(cv2.cvtColor(picture, cv2.COLOR_RGB2GRAY), np.uint8)
    found, ids, _ = _detector().detectMarkers(grey)
    if ids is None:
        return {}
    numbers = [int(number) for number in ids.ravel()]
    return {
        number: refined
        for number, rough in zip(numbers, found, strict=True)
        if number in _KNOWN and numbers.count(number) == 1
        if (refined := _refined(grey, rough.reshape(4, 2).astype(np.float64))) is not None
    }


def _refined(grey: Picture, rough: Corners) -> Corners | None:
    """Returns the corners as the crossings of lines through the black square's edges; None if they are not clear.

    An edge is averaged over many places, so a corner is found to less than a tenth of a pixel where blur rounds it.
    """
    if np.linalg.norm(rough - np.roll(rough, 1, axis=0), axis=1).min() < _MIN_SIDE_PX:
        return None
    smooth = grey.astype(np.float32)
    lines = [_edge_line(smooth, rough, side) for side in range(4)]
    corners = np.array([_crossing(lines[side - 1], lines[side]) for side in range(4)])
    is_near = np.abs(corners - rough).max() < _REACH_PX  # also refuses NaN
    return corners if is_near else None


def _edge_line(grey: NDArray[np.float32], corners: Corners, side: int) -> Line:
    """Fits a line through the places at which the picture is steepest across an edge, from black to white."""
    begin, end = corners[side], corners[(side + 1) % 4]
    along = (end - begin) / np.linalg.norm(end - begin)
    out = np.array([along[1], -along[0]])
    if out @ (begin - corners.mean(axis=0)) < 0:
        out = -out
    parts = np.linspace(0.12, 0.88, max(8, int(np.linalg.norm(end - begin))))
    places = begin + parts[:, None] * (end - begin)
    px = (places[:, None] + _ACROSS[:, None] * out).astype(np.float32)
    values = cv2.remap(grey, px[..., 0], px[..., 1], cv2.INTER_LINEAR)
    steep = np.clip(np.gradient(values, axis=1), 0, None)
    off = (steep * _ACROSS).sum(axis=1) / np.maximum(steep.sum(axis=1), 1e-6)
    on_edge = places + off[:, None] * out
    middle = on_edge.mean(axis=0)
    return middle, np.linalg.svd(on_edge - middle)[2][0]


def _crossing(one: Line, other: Line) -> NDArray[np.float64]:
    """Returns where two lines cross, NaN if they are parallel."""
    (place, along), (place_2, along_2) = one, other
    across = along[0] * along_2[1] - along[1] * along_2[0]
    if abs(across) < _PARALLEL:
        return np.full(2, np.nan)
    gap = place_2 - place
    return np.asarray(place + along * (gap[0] * along_2[1] - gap[1] * along_2[0]) / across)


@lru_cache(maxsize=1)
def _detector() -> "cv2.aruco.ArucoDetector":
    parameters = cv2.aruco.DetectorParameters()
    parameters.minMarkerPerimeterRate = 0.02
    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
    return cv2.aruco.ArucoDetector(dictionary, parameters)
