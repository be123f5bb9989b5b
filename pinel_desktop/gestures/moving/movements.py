"""Movements of a hand: segments of a video from rest to rest, resampled to a fixed form.

A movement has 38 frames of 46 numbers: 21 landmarks (x, y) relative to the middle of the palm, the path of the palm
relative to its start, the logarithm of the hand's relative size, and the time in s.

Lengths are in hand sizes; left hands are mirrored. The frames divide the duration evenly, so that only the time depends
on the speed of the movement.
"""

from collections import deque
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.float32]
Movement = NDArray[np.float32]

N_FRAMES, N_NUMBERS = 38, 46
SHAPE, PATH, GROWTH, TIME = slice(0, 42), slice(42, 44), 44, 45

BEGINS_HZ = 0.9  # minimum speed of a moving hand, hand sizes/s
RESTS_HZ = 0.7  # upper bound of the speed of a resting hand, hand sizes/s
REST_S = 0.25  # minimum rest that ends a movement; the stops at the corners of a Z are shorter
MIN_DURATION_S, MAX_DURATION_S = 0.25, 4.0  # of a movement
MIN_DISPLACEMENT = 0.2  # of the landmarks from their start, hand sizes
_SPAN_S = 0.18  # time span of the speed measurement; over single frames landmark noise is too large
_MIN_FRAMES = 4
_GAP_S = 0.3  # after a longer gap a hand counts as another hand
_PALM = [0, 1, 5, 9, 13, 17]


@dataclass(frozen=True, slots=True)
class HandObservation:
    """A hand in one frame: time in s, landmarks (21, 2) in px, whether it is a left hand."""

    time_s: float
    points: Points
    is_left: bool


def movement(observations: list[HandObservation]) -> Movement:
    """Resamples at least two frames, the earliest first, to a movement (38, 46)."""
    times = np.array([one.time_s for one in observations]) - observations[0].time_s
    points = np.array([one.points for one in observations], np.float64)
    if 2 * sum(one.is_left for one in observations) > len(observations):
        points[..., 0] *= -1
    points = _smoothed(points)
    middles = points[:, _PALM].mean(1)
    sizes = _sizes(points)
    size = float(np.median(sizes)) + 1e-6
    numbers = np.empty((len(times), N_NUMBERS))
    numbers[:, SHAPE] = ((points - middles[:, None]) / size).reshape(len(times), -1)
    numbers[:, PATH] = (middles - middles[0]) / size
    numbers[:, GROWTH] = np.log((sizes + 1e-6) / size)
    numbers[:, TIME] = times
    at = np.linspace(0.0, times[-1], N_FRAMES)
    columns = [np.interp(at, times, column) for column in numbers.T]
    return np.stack(columns, axis=1).astype(np.float32)


def shape(points: Points, *, is_left: bool) -> NDArray[np.float64]:
    """Returns the landmarks (21, 2) of one frame in the form of the frames of a movement, (42,)."""
    upright = points.astype(np.float64)
    if is_left:
        upright[:, 0] *= -1
    size = float(_sizes(upright[None])[0]) + 1e-6
    numbers: NDArray[np.float64] = ((upright - upright[_PALM].mean(0)) / size).ravel()
    return numbers


class MovementSegmenter:
    """Segments movements in a video, frame by frame: from a hand at rest to the same hand at rest again."""

    def __init__(self) -> None:
        self.reset()

    def reset(self) -> None:
        """Discards all frames."""
        self._observations: deque[HandObservation] = deque()
        self._is_moving = False
        self._has_rested = False
        self._rests_since_s: float | None = None

    @property
    def is_moving(self) -> bool:
        return self._is_moving

    def update(self, observation: HandObservation) -> Movement | None:
        """Adds the next frame with a hand; returns the movement that ends with it, or None."""
        if self._observations and observation.time_s - self._observations[-1].time_s > _GAP_S:
            self.reset()
        self._observations.append(observation)
        speed = self._speed()
        if speed is None:
            return None
        if not self._is_moving:
            self._wait(speed)
            return None
        if speed >= RESTS_HZ:
            self._rests_since_s = None
            if observation.time_s - self._observations[0].time_s > MAX_DURATION_S:
                self._has_rested = False  # the rest before the movement is too long ago
                self._observations.popleft()
            return None
        if self._rests_since_s is None:
            self._rests_since_s = observation.time_s
        return self._ended() if observation.time_s - self._rests_since_s >= REST_S else None

    def _wait(self, speed: float) -> None:
        """Checks whether a resting hand starts to move. Until then, discards frames that its speed does not need."""
        self._has_rested = self._has_rested or speed < RESTS_HZ
        self._is_moving = speed >= BEGINS_HZ
        oldest_s = self._observations[-1].time_s - 2 * _SPAN_S
        while not self._is_moving and self._observations[0].time_s < oldest_s:
            self._observations.popleft()

    def _ended(self) -> Movement | None:
        """Returns the movement up to the rest; None if it has too few frames or a wrong duration, or is too small."""
        rests_since_s = self._rests_since_s or 0.0
        frames = [one for one in self._observations if one.time_s <= rests_since_s]
        remaining = [one for one in self._observations if one.time_s > rests_since_s]
        has_rested = self._has_rested
        self.reset()
        self._observations.extend(remaining)
        lasted_s = frames[-1].time_s - frames[0].time_s if frames else 0.0
        if (
            not has_rested
            or len(frames) < _MIN_FRAMES
            or not MIN_DURATION_S <= lasted_s <= MAX_DURATION_S
        ):
            return None
        farthest = max(_displacement(frames[0].points, one.points) for one in frames)
        return movement(frames) if farthest >= MIN_DISPLACEMENT else None

    def _speed(self) -> float | None:
        """Returns the speed over the last `_SPAN_S`, in hand sizes/s; None if the hand has just appeared."""
        now = self._observations[-1]
        for before in reversed(self._observations):
            elapsed_s = now.time_s - before.time_s
            if elapsed_s >= _SPAN_S:
                return _displacement(before.points, now.points) / elapsed_s
        return None


def _displacement(before: Points, now: Points) -> float:
    """Returns the root mean square displacement of the landmarks, in hand sizes."""
    size = float(np.ptp(now, axis=0).max()) + 1e-6
    return float(np.sqrt(((now - before) ** 2).sum(axis=1).mean())) / size


def _sizes(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Returns the root mean square distance of the landmarks (n, 21, 2) from their centroid, (n,)."""
    spread = points - points.mean(1, keepdims=True)
    sizes: NDArray[np.float64] = np.sqrt((spread**2).sum(2).mean(1))
    return sizes


def _smoothed(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Returns each frame as the mean of itself and its neighbours."""
    padded = np.concatenate([points[:1], points, points[-1:]])
    mean: NDArray[np.float64] = (padded[:-2] + padded[1:-1] + padded[2:]) / 3
    return mean
