"""Feature vector of a hand: 852 shape features, and 896 activations of the landmark network at the fingers.

The features do not depend on the hand's size, position and chirality. They do depend on its direction in the picture,
because letters such as M and W differ by it. The activations distinguish hands with the same landmarks, such as which
finger is in front.
"""

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures.landmarks import SIZE, Hand

Array = NDArray[np.float64]

N_SHAPE, N_ACTIVATIONS = 852, 896
N_FEATURES = N_SHAPE + N_ACTIVATIONS
_IN_PALM = slice(60, 120)  # position of the landmarks in the palm's frame, in the order of `_shape`
# all features of a block, and both blocks, weigh equally in the classifier
BLOCKS = (slice(0, N_SHAPE), slice(N_SHAPE, N_SHAPE + N_ACTIVATIONS))

# each landmark but the wrist is the end of a bone that starts at its parent
_ENDS = np.arange(1, 21)
_STARTS = np.array([0, 1, 2, 3, 0, 5, 6, 7, 0, 9, 10, 11, 0, 13, 14, 15, 0, 17, 18, 19])
_BENT = np.flatnonzero(_STARTS)  # bones that continue another bone
_THUMB_BASE, _INDEX_BASE, _MIDDLE_BASE, _RING_BASE, _LITTLE_BASE = 1, 5, 9, 13, 17
_NEIGHBOURS = (
    (_INDEX_BASE, _MIDDLE_BASE),
    (_MIDDLE_BASE, _RING_BASE),
    (_RING_BASE, _LITTLE_BASE),
    (_THUMB_BASE, _INDEX_BASE),
)
_THUMB_TIP, _FINGERS = 4, slice(5, 21)
_INDEX_JOINTS, _MIDDLE_JOINTS = [8, 7, 6], [12, 11, 10]
_PAIRS = np.triu_indices(21, 1)
# thumb, index and middle finger, by which most letters differ
_ACTIVATION_LANDMARKS = [2, 3, 4, 6, 7, 8, 11, 12]


def features(hand: Hand) -> NDArray[np.float32]:
    """Returns the feature vector of a hand, (1748,)."""
    shape = [np.ravel(part) for part in _shape(hand)]
    return np.concatenate([*shape, _sampled_activations(hand)]).astype(np.float32)


def palm_landmarks(features: NDArray[np.float32]) -> Array:
    """Returns the landmarks (21, 3) of a hand from its feature vector (1748,).

    Frame: across the palm, along it towards the middle finger, perpendicular to it; the wrist is the origin, the unit
    is three mean bone lengths. It turns with the hand, and left hands are mirrored.
    """
    return np.vstack([np.zeros(3), features[_IN_PALM].astype(np.float64).reshape(20, 3)])


def _shape(hand: Hand) -> Iterator[Array | list[float]]:
    """Yields positions, directions, angles and distances of landmarks, in the frames of the picture, crop and palm."""
    upright = _unmirrored(hand)
    world = _from_wrist(hand.world)
    in_crop = _from_wrist(hand.in_crop)
    palm = _palm_axes(world)
    in_palm = world @ palm.T
    turn = math.atan2(upright[_MIDDLE_BASE, 0], -upright[_MIDDLE_BASE, 1])
    bones = _unit(in_palm[_ENDS] - in_palm[_STARTS])
    yield from (upright[1:, :2], upright[1:, 2], in_palm[1:], in_crop[1:])
    yield from ([math.sin(turn), math.cos(turn)], palm)
    yield from (bones, _unit(upright[_ENDS, :2] - upright[_STARTS, :2]))
    yield from (_bends(bones), _spreads(bones))
    for points in (in_palm, in_crop):
        yield points[_THUMB_TIP] - points[_FINGERS]
    for points in (in_palm, in_crop):
        yield points[_INDEX_JOINTS] - points[_MIDDLE_JOINTS]
    yield from (_distances(world), _distances(in_crop[:, :2]))


def _unmirrored(hand: Hand) -> Array:
    """Returns the landmarks (21, 3) in the picture's axes, as a right hand.

    The origin is the wrist; the unit is the hand's size.
    """
    points = hand.points - hand.points[0]
    if hand.mirrored:
        points[:, 0] *= -1
    scaled: Array = points / (math.sqrt(float((points[:, :2] ** 2).sum(1).mean())) + 1e-6)
    return scaled


def _from_wrist(points: Array) -> Array:
    """Returns the landmarks (21, 3) relative to the wrist, in units of three mean bone lengths."""
    lengths = np.linalg.norm(points[_ENDS] - points[_STARTS], axis=1)
    scaled: Array = (points - points[0]) / (3 * float(lengths.mean()) + 1e-9)
    return scaled


def _palm_axes(world: Array) -> Array:
    """Returns the axes of the palm as rows: across it, along it towards the middle finger, perpendicular to it."""
    along = _unit(world[_MIDDLE_BASE])
    away = _unit(np.cross(world[_INDEX_BASE] - world[_LITTLE_BASE], along))
    return np.stack([np.cross(along, away), along, away])


def _bends(bones: Array) -> Array:
    """Returns the cosine of the angle between each bone and the bone before it, (15,)."""
    cosines: Array = np.einsum("ij,ij->i", bones[_BENT], bones[_STARTS[_BENT] - 1])
    return cosines


def _spreads(bones: Array) -> list[float]:
    """Returns the cosines of the angles between the three bones of neighbouring fingers, (12,)."""
    return [float(bones[a + i] @ bones[b + i]) for a, b in _NEIGHBOURS for i in range(3)]


def _distances(points: Array) -> Array:
    """Returns the distances between all pairs of landmarks, (210,)."""
    distances: Array = np.linalg.norm(points[_PAIRS[0]] - points[_PAIRS[1]], axis=1)
    return distances


def _sampled_activations(hand: Hand) -> Array:
    """Returns the network's activations, interpolated bilinearly at 8 landmarks, (896,)."""
    grid = hand.activations
    cells = grid.shape[0]
    at = np.clip(hand.in_crop[_ACTIVATION_LANDMARKS, :2] * cells / SIZE - 0.5, 0, cells - 1.001)
    column, row = at.astype(int).T
    right, down = (at % 1).T[..., None]
    upper = grid[row, column] * (1 - right) + grid[row, column + 1] * right
    lower = grid[row + 1, column] * (1 - right) + grid[row + 1, column + 1] * right
    mixed: Array = (upper * (1 - down) + lower * down).ravel()
    return mixed


def _unit(vectors: Array) -> Array:
    scaled: Array = vectors / (np.linalg.norm(vectors, axis=-1, keepdims=True) + 1e-9)
    return scaled
