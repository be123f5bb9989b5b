"""Landmarks of a typical hand for a taught sign, to draw the sign. Without numpy: the app does not import it."""

import struct
from collections.abc import Iterable, Sequence

_N_BENEATH = 20  # landmarks but the wrist, which is the origin

# a sample starts with x and y of the landmarks from the wrist, then their z (`features.features`)
_POSITION = struct.Struct(f"<{3 * _N_BENEATH}e")
# a movement starts with x and y of all landmarks in its first frame (`movements.movement`)
_BEGINNING = struct.Struct(f"<{2 * (_N_BENEATH + 1)}e")

Landmarks = list[list[float]]


def medoid_landmarks(samples: Iterable[bytes]) -> Landmarks:
    """Returns the landmarks (21, 3) of the sample that is nearest to the mean of all samples.

    Args:
        samples: feature vectors of one hand each, float16, little-endian; at least one.

    Returns:
        x to the right, y down, z away from the viewer, in units of the hand's size; the origin is the wrist. The hand
        is a right hand in a mirror.
    """
    hands = [_POSITION.unpack_from(sample) for sample in samples]
    mean = [sum(numbers) / len(hands) for numbers in zip(*hands, strict=True)]
    nearest = min(hands, key=lambda hand: _distance(hand, mean))
    flat, depths = nearest[: 2 * _N_BENEATH], nearest[2 * _N_BENEATH :]
    # a mirror inverts x of the camera's picture
    points = zip(flat[::2], flat[1::2], depths, strict=True)
    return [[0.0, 0.0, 0.0], *([round(-x, 3), round(y, 3), round(z, 3)] for x, y, z in points)]


def landmarks_of_movement(samples: bytes) -> Landmarks:
    """Returns the hand (21, 3) at the start of the first movement, in the form of `medoid_landmarks`, with z = 0."""
    numbers = _BEGINNING.unpack_from(samples)
    points = list(zip(numbers[::2], numbers[1::2], strict=True))
    (wrist_x, wrist_y), *_ = points
    return [[round(wrist_x - x, 3), round(y - wrist_y, 3), 0.0] for x, y in points]


def _distance(hand: Sequence[float], other: Sequence[float]) -> float:
    return sum((a - b) ** 2 for a, b in zip(hand, other, strict=True))
