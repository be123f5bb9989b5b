"""Compares figures on the floor: the fit of a drawing to a template, and axes of symmetry.

Points have shape (n, 2), in m. Lines are sampled every 2 cm, and each cell of 2 cm counts one point. A line that
was drawn twice therefore weighs no more than another line.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.float64]
STEP_M = 0.02
_MIN_SIZE_M = 0.01  # r.m.s. size below which a drawing is a dot
_SEARCH_DEG = 3
_N_SEARCH, _N_FIT, _N_ROUNDS, _N_BEST = 90, 240, 20, 4
_N_MIRRORED = (16, 60, 240)
_AXIS_STEP_DEG = 0.5


@dataclass(frozen=True, slots=True)
class Sampled:
    """Points of lines, and for each point its place along the lines as an index of the recorded samples."""

    points: Points
    indices: NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class Fit:
    """The fit of a drawing to a template, in the template's metres.

    Attributes:
        missing_m: distance of the template's farthest point from the drawing.
        extra_m: distance of the drawing's farthest point from the template.
        worst: index of the drawing's farthest point.
        scale: size of the template divided by the size of the drawing.
    """

    missing_m: float
    extra_m: float
    worst: int
    scale: float

    @property
    def off_m(self) -> float:
        return max(self.missing_m, self.extra_m)


@dataclass(frozen=True, slots=True)
class Freedom:
    """Transformations that a fit may choose: scaling, rotation, translation, mirroring."""

    scale: bool = True
    rotate: bool = True
    move: bool = True
    mirror: bool = False


def sampled(
    lines: Sequence[Points], starts: Sequence[int] | None = None, step_m: float = STEP_M
) -> Sampled:
    """Samples lines at equal steps.

    Args:
        starts: index of the first sample of each line; None for 0.
    """
    points: list[Points] = [np.empty((0, 2))]
    places: list[NDArray[np.int64]] = [np.empty(0, dtype=np.int64)]
    for i, line in enumerate(lines):
        along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(line, axis=0).T))])
        at = np.append(np.arange(0.0, along[-1], step_m), along[-1])
        points.append(np.column_stack([np.interp(at, along, line[:, k]) for k in (0, 1)]))
        index = np.searchsorted(along, at, side="left").clip(0, len(line) - 1)
        places.append(index + (starts[i] if starts else 0))
    together, where = np.concatenate(points), np.concatenate(places)
    cells = np.rint(together / step_m).astype(np.int64)
    _, first = np.unique(cells, axis=0, return_index=True)
    first.sort()
    return Sampled(together[first], where[first])


def at_steps(points: Points, step_m: float) -> Points:
    """Returns the points that are at least a step from the last returned point, and the last point."""
    retained = [points[0]]
    x, y = float(points[0, 0]), float(points[0, 1])
    for index, (px, py) in enumerate(points.tolist()):
        if (px - x) ** 2 + (py - y) ** 2 >= step_m**2:
            retained.append(points[index])
            x, y = px, py
    return np.array([*retained, points[-1]])


def length(points: Points) -> float:
    """Length of a line."""
    return float(np.hypot(*np.diff(points, axis=0).T).sum())


def best_fit(template: Points, drawing: Points, freedom: Freedom) -> Fit:
    """Returns the best fit of a drawing to a template; both as `sampled` returns them."""
    if not len(drawing):
        far = float(np.max(_lengths(template - template.mean(axis=0)), initial=0.0))
        return Fit(far, 0.0, 0, 1.0)
    sides = (1.0, -1.0) if freedom.mirror else (1.0,)
    fits = [_fit(template * (1.0, side), drawing, freedom) for side in sides]
    return min(fits, key=lambda fit: fit.off_m)


def _fit(template: Points, drawing: Points, freedom: Freedom) -> Fit:
    middle = template.mean(axis=0) if freedom.move else np.zeros(2)
    centred_template = template - middle
    drawn = drawing - (drawing.mean(axis=0) if freedom.move else 0.0)
    size, template_size = _rms(drawn), _rms(centred_template)
    scale = template_size / size if freedom.scale and size > _MIN_SIZE_M else 1.0
    drawn = drawn * scale
    starts = _best_turns(centred_template, drawn) if freedom.rotate else [0.0]
    fits = [_refined(centred_template, _turned(drawn, turn), freedom, scale) for turn in starts]
    return min(fits, key=lambda fit: fit.off_m)


def _best_turns(template: Points, drawn: Points) -> list[float]:
    """Returns the most promising rotations, in rad."""
    few, others = _thinned(template, _N_SEARCH), _thinned(drawn, _N_SEARCH)
    turns = np.radians(np.arange(0, 360, _SEARCH_DEG))
    costs = []
    for turn in turns:
        far = _distances(few, _turned(others, turn))
        costs.append(float(far.min(axis=0).mean() + far.min(axis=1).mean()))
    return [float(turns[i]) for i in np.argsort(costs, kind="stable")[:_N_BEST]]


def _refined(template: Points, drawn: Points, freedom: Freedom, scale: float) -> Fit:
    """Refines a fit by iterative closest points, in both directions, until the drawing moves no more."""
    few, moving = _thinned(template, _N_FIT), _thinned(drawn, _N_FIT)
    whole = drawn
    for _ in range(_N_ROUNDS):
        far = _distances(few, moving)
        sources = np.concatenate([moving, moving[far.argmin(axis=1)]])
        targets = np.concatenate([few[far.argmin(axis=0)], few])
        turn, factor, shift = _similarity(sources, targets, freedom)
        moving, whole = (_turned(points, turn) * factor + shift for points in (moving, whole))
        scale *= factor
        if abs(turn) + abs(factor - 1.0) + float(np.abs(shift).sum()) < 1e-4:
            break
    missing, extra, worst = _extremes(template, whole)
    return Fit(missing, extra, worst, scale)


def _similarity(sources: Points, targets: Points, freedom: Freedom) -> tuple[float, float, Points]:
    """Returns rotation (rad), factor and shift that bring points closest to others, pair by pair (least squares)."""
    from_, to = (
        (sources.mean(axis=0), targets.mean(axis=0)) if freedom.move else (np.zeros(2), np.zeros(2))
    )
    a, b = sources - from_, targets - to
    along = float((a * b).sum())
    across = float((a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum())
    turn = float(np.arctan2(across, along)) if freedom.rotate else 0.0
    factor = 1.0
    if freedom.scale and (square := float((a * a).sum())) > 0.0:
        factor = float((_turned(a, turn) * b).sum()) / square
        factor = min(max(factor, 0.9), 1.1)
    shift: Points = to - _turned(from_[None, :], turn)[0] * factor
    return turn, factor, shift


def _extremes(template: Points, drawn: Points) -> tuple[float, float, int]:
    missing, extra = nearest(template, drawn), nearest(drawn, template)
    worst = int(extra.argmax())
    return float(missing.max()), float(extra[worst]), worst


def nearest(points: Points, others: Points) -> Points:
    """Returns the distance (m) of each point from the nearest of the others, shape (n,)."""
    parts = [
        _distances(points[i : i + 500], others).min(axis=1) for i in range(0, len(points), 500)
    ]
    found: Points = np.concatenate(parts) if parts else np.empty(0)
    return found


def fine_step_m(drawing: Points) -> float:
    """Returns a step (m) that is small relative to a drawing, for comparing the drawing with itself."""
    size = _rms(drawing - drawing.mean(axis=0)) if len(drawing) else 1.0
    return min(STEP_M, max(0.004, size * 0.015))


def axes_of_symmetry(drawing: Points, tolerance: float) -> int:
    """Returns the number of mirror axes through the centroid; at most 180.

    Args:
        tolerance: largest distance of a mirrored point from the drawing, in r.m.s. radii.
    """
    if not len(drawing):
        return 0
    points = drawing - drawing.mean(axis=0)
    size = _rms(points)
    if size < _MIN_SIZE_M:
        return 0
    points = points / size
    samples = [_thinned(points, n) for n in _N_MIRRORED]
    angles = np.radians(np.arange(0.0, 180.0, _AXIS_STEP_DEG))
    # a few points suffice to exclude most angles
    is_axis = [
        all(_mirror_error(few, points, angle) <= tolerance for few in samples) for angle in angles
    ]
    return _runs(np.array(is_axis))


def _mirror_error(few: Points, points: Points, angle: float) -> float:
    cos, sin = np.cos(2 * angle), np.sin(2 * angle)
    mirrored = few @ np.array([[cos, sin], [sin, -cos]])
    return float(nearest(mirrored, points).max())


def _runs(low: NDArray[np.bool_]) -> int:
    """Returns the number of runs of True on a circle; 180 if all are True, as for a drawn circle."""
    if low.all():
        return int(len(low) * _AXIS_STEP_DEG)
    return int(np.count_nonzero(low & ~np.roll(low, 1)))


def _thinned(points: Points, max_points: int) -> Points:
    if len(points) <= max_points:
        return points
    thinned: Points = points[np.linspace(0, len(points) - 1, max_points).astype(int)]
    return thinned


def _distances(points: Points, others: Points) -> Points:
    """Returns the distances (m) of all pairs, shape (n, m)."""
    x = points[:, 0, None] - others[None, :, 0]
    y = points[:, 1, None] - others[None, :, 1]
    far: Points = np.sqrt(x * x + y * y)
    return far


def _turned(points: Points, angle_rad: float) -> Points:
    cos, sin = np.cos(angle_rad), np.sin(angle_rad)
    turned: Points = points @ np.array([[cos, sin], [-sin, cos]])
    return turned


def _lengths(points: Points) -> Points:
    lengths: Points = np.hypot(points[:, 0], points[:, 1])
    return lengths


def _rms(points: Points) -> float:
    return float(np.sqrt((points * points).sum(axis=1).mean()))
