"""Synthetic moving signs: landmarks of photographed hands, moved along computed paths.

There are no recordings of moving letters of people who may be shown here. So path, rotation and speed of the hand are
synthetic. The landmarks, their noise and the differences between people come from the networks on real photographs.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures.moving.movements import HandObservation

RATE_HZ = 15.0
MOVING = {"H": "K", "J": "I", "X": "D", "Z": "D"}
"""The moving letters, and the letter whose hand makes them; X bends its index finger."""

Array = NDArray[np.float64]
Random = np.random.Generator

_BEFORE_S, _AFTER_S = (0.3, 0.8), (0.6, 1.2)  # rest before and after the movement
_SPEEDS, _AMPLITUDES = (0.7, 1.5), (0.75, 1.3)
_TILT_DEG, _WOBBLE = 10.0, 0.05  # of the path: rotation in degrees, deviation in hand sizes
_TREMOR = 0.012  # of a resting hand, hand sizes
_SIZES_PX = (70.0, 170.0)  # of a hand in a frame of 640 x 480


@dataclass(frozen=True)
class Pose:
    """The hand's pose at one time of a movement.

    x, y: position in hand sizes. twist: radians about the forearm. roll: radians in the picture.
    growth: scale factor of the hand.
    """

    x: float = 0.0
    y: float = 0.0
    twist: float = 0.0
    roll: float = 0.0
    growth: float = 1.0


Path = Callable[[float], Pose]
"""A movement: its pose at each share, 0 to 1, of its time."""


@dataclass(frozen=True)
class Model:
    """A hand to be moved: n frames (n, 21, 3) of landmarks with noise, upright, in hand sizes relative to the wrist."""

    frames: Array

    @classmethod
    def of(cls, features: NDArray[np.float32]) -> "Model":
        """Creates a model from the features (n, 1748) of n frames of a hand at rest."""
        flat = features[:, :40].reshape(-1, 20, 2).astype(np.float64)
        deep = features[:, 40:60, None].astype(np.float64)
        frames = np.concatenate([flat, deep], axis=2)
        frames = np.concatenate([np.zeros((len(frames), 1, 3)), frames], axis=1)
        return cls(frames / np.ptp(frames.mean(0)[:, :2], axis=0).max())

    def hooked(self) -> "Model":
        """Returns the model with its index finger bent, as for X."""
        frames = self.frames.copy()
        for frame in frames:
            across = frame[17] - frame[5]
            _bend(frame, 6, [7, 8], across, np.radians(75))
            _bend(frame, 7, [8], across, np.radians(60))
        return Model(frames)

    def moved(self, i: int, pose: Pose) -> Array:
        """Returns the landmarks (21, 2) of frame i in a pose, in hand sizes; i runs through the frames to and fro."""
        n = len(self.frames)
        k = i % (2 * n - 2) if n > 1 else 0
        points = self.frames[k if k < n else 2 * n - 2 - k]
        forearm = self.frames.mean(0)[9]
        points = points @ _turn(forearm, pose.twist).T @ _turn(np.array([0, 0, 1.0]), pose.roll).T
        moved: Array = pose.growth * points[:, :2] + (pose.x, pose.y)
        return moved


def smooth(share: float) -> float:
    """Returns the covered share of the path at a share of the time: minimum jerk (Flash and Hogan, 1985)."""
    s = min(max(share, 0.0), 1.0)
    return s**3 * (10 - 15 * s + 6 * s * s)


def strokes(*corners: tuple[float, float]) -> Path:
    """Returns a path of straight strokes from the origin over these corners, each stroke from rest to rest."""
    places = [(0.0, 0.0), *corners]

    def path(share: float) -> Pose:
        at = min(share * len(corners), len(corners) - 1e-9)
        (x, y), (to_x, to_y), part = places[int(at)], places[int(at) + 1], smooth(at % 1)
        return Pose(x + (to_x - x) * part, y + (to_y - y) * part)

    return path


def letter_path(letter: str) -> tuple[Path, float]:
    """Returns the path of a moving letter, and its usual duration in s."""
    if letter == "H":
        return (lambda share: Pose(0.08 * smooth(share), 0.0, np.radians(150) * smooth(share))), 0.8
    if letter == "X":
        return (
            lambda share: Pose(
                0.5 * smooth(share), 0.1 * smooth(share), growth=1 - 0.2 * smooth(share)
            )
        ), 0.7
    if letter == "Z":
        return strokes((0.6, 0.0), (0.0, 0.6), (0.6, 0.6)), 1.4
    return _hook, 1.0


def _hook(share: float) -> Pose:
    """Returns a pose on the path of J: down, then in an arc to the side, while the hand rotates."""
    s = smooth(share)
    if s < 0.55:
        return Pose(0.0, 0.55 * s / 0.55)
    angle = np.pi * (s - 0.55) / 0.45
    twist = np.radians(50) * (s - 0.55) / 0.45
    return Pose(-0.22 + 0.22 * np.cos(angle), 0.55 + 0.22 * np.sin(angle), twist)


def still(lasts_s: float) -> tuple[Path, float]:
    """Returns a path without movement, and its duration in s."""
    return (lambda share: Pose()), lasts_s


def signed(model: Model, path: Path, lasts_s: float, random: Random) -> list[HandObservation]:
    """Returns a video of a hand that rests, moves and rests, with random speed, size and position."""
    before, after = random.uniform(*_BEFORE_S), random.uniform(*_AFTER_S)
    lasts = lasts_s / random.uniform(*_SPEEDS)
    total = before + lasts + after
    amplitude, tilt = random.uniform(*_AMPLITUDES), np.radians(random.normal(0, _TILT_DEG))
    stray = random.normal(0, _WOBBLE, (2, 3))
    tremor = random.normal(0, _TREMOR, (2, 4))
    tremor_hz, phase = random.uniform(0.4, 3.0, 4), random.uniform(0, 6.3, 4)
    size, place = random.uniform(*_SIZES_PX), random.uniform((240, 260), (400, 340))
    is_left = bool(random.random() < 0.2)
    offset = int(random.integers(100))
    observations = []
    for i in range(int(total * RATE_HZ)):
        time_s = max(i / RATE_HZ + random.normal(0, 0.005), 0.0)
        share = min(max((time_s - before) / lasts, 0.0), 1.0)
        pose = path(share)
        wander = stray @ np.sin(np.pi * np.arange(1, 4) * smooth(share))
        shake = tremor @ np.sin(2 * np.pi * tremor_hz * time_s + phase)
        x, y = np.array([pose.x, pose.y]) * amplitude + wander
        turned = np.array(
            [x * np.cos(tilt) - y * np.sin(tilt), x * np.sin(tilt) + y * np.cos(tilt)]
        )
        twist = pose.twist * (0.6 + 0.4 * amplitude)
        at_x, at_y = turned + shake
        there = replace(pose, x=at_x, y=at_y, twist=twist)
        points = model.moved(offset + i, there) * size
        if is_left:
            points[:, 0] *= -1
        observations.append(HandObservation(time_s, (points + place).astype(np.float32), is_left))
    return observations


def aimless(random: Random) -> tuple[Path, float]:
    """Returns a random path that is no sign, and its duration in s: to a side, to and fro, round, or irregular."""
    kind = int(random.integers(6))
    angle = random.uniform(0, 2 * np.pi)
    x, y = np.array([np.cos(angle), np.sin(angle)]) * random.uniform(0.3, 1.2)
    if kind == 0:
        return strokes((x, y)), random.uniform(0.4, 1.2)
    if kind == 1:
        return strokes((x, y), (0, 0)), random.uniform(0.7, 1.5)
    if kind == 2:
        corners = np.cumsum(random.normal(0, 0.5, (int(random.integers(2, 5)), 2)), 0)
        return strokes(*map(tuple, corners)), random.uniform(0.8, 2.5)
    if kind == 3:
        radius, turns = random.uniform(0.15, 0.5), random.choice([-1, 1]) * random.uniform(0.7, 1.5)
        return (
            lambda s: Pose(
                radius * (np.cos(2 * np.pi * turns * smooth(s) + angle) - np.cos(angle)),
                radius * (np.sin(2 * np.pi * turns * smooth(s) + angle) - np.sin(angle)),
            )
        ), random.uniform(0.8, 1.6)
    if kind == 4:
        roll, twist = random.normal(0, 0.6), random.normal(0, 0.5)
        return (
            lambda s: Pose(x * smooth(s), y * smooth(s), twist * smooth(s), roll * smooth(s))
        ), random.uniform(0.4, 1.2)
    waves, reach = int(random.integers(2, 4)), random.uniform(0.2, 0.6)
    side = np.array([np.cos(angle), np.sin(angle)]) * reach
    return (lambda s: Pose(*(side * np.sin(2 * np.pi * waves * s)))), random.uniform(0.8, 1.8)


def changed(first: Model, second: Model, random: Random) -> list[HandObservation]:
    """Returns a video of two letters in sequence; between them the hand drifts by up to a third of its size."""
    lasts = random.uniform(0.2, 0.6)
    size, place = random.uniform(*_SIZES_PX), random.uniform((240, 260), (400, 340))
    goal = random.normal(0, 0.15, 2)
    rests = random.uniform(0.6, 1.2, 2)
    observations = []
    for i in range(int((rests.sum() + lasts) * RATE_HZ)):
        time_s = i / RATE_HZ
        share = smooth((time_s - rests[0]) / lasts)
        mixed = first.moved(i, Pose()) * (1 - share) + second.moved(i, Pose()) * share
        points = (mixed + goal * share) * size + place
        observations.append(HandObservation(time_s, points.astype(np.float32), False))
    return observations


def _bend(frame: Array, joint: int, ends: Sequence[int], axis: Array, angle: float) -> None:
    frame[ends] = frame[joint] + (frame[ends] - frame[joint]) @ _turn(axis, angle).T


def _turn(axis: Array, angle: float) -> Array:
    """Returns the matrix (3, 3) of a rotation about an axis (Rodrigues)."""
    x, y, z = axis / (np.linalg.norm(axis) + 1e-9)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    matrix: Array = np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    return matrix
