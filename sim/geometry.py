"""Crossings, overlaps and distances of segments and rectangles, vectorised. All lengths are in metres."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Pairs = NDArray[np.intp]


def crossings(segments: Array, tolerance_m: float) -> Pairs:
    """Returns pairs of indices (k, 2), the smaller first, of the segments (n, 2, 2) that cross.

    A segment that ends on another one, or at most `tolerance_m` beyond it, does not cross it.
    """
    left_of_start, left_of_end = (_offsets(segments, segments[:, end]) for end in (0, 1))
    low, high = np.minimum(left_of_start, left_of_end), np.maximum(left_of_start, left_of_end)
    straddles = (low < -tolerance_m) & (high > tolerance_m)
    pairs: Pairs = np.argwhere(np.triu(straddles & straddles.T, k=1))
    return pairs


def _offsets(segments: Array, points: Array) -> Array:
    """Returns the signed distance (n, m) of point j from the line through segment i, positive to the left."""
    starts, along = segments[:, 0], segments[:, 1] - segments[:, 0]
    normals = np.stack([-along[:, 1], along[:, 0]], axis=1)
    normals /= np.maximum(np.hypot(*along.T), 1e-12)[:, None]
    offsets: Array = normals @ points.T - np.einsum("ik,ik->i", normals, starts)[:, None]
    return offsets


def distances_to_segments(point: Array, segments: Array) -> Array:
    """Returns the distance (n) from a point (2) to each segment (n, 2, 2)."""
    starts, along = segments[:, 0], segments[:, 1] - segments[:, 0]
    length2 = np.maximum(np.einsum("ik,ik->i", along, along), 1e-24)
    share = np.clip(np.einsum("ik,ik->i", point - starts, along) / length2, 0.0, 1.0)
    gaps = point - (starts + share[:, None] * along)
    distances: Array = np.hypot(*gaps.T)
    return distances


def distances_to_boxes(point: Array, corners: Array) -> Array:
    """Returns the distance (n) from a point (2) to each rectangle (n, 4, 2), corners in order; 0 inside."""
    centers, axes = corners.mean(axis=1), _axes(corners)
    halves = np.hypot(*np.moveaxis(corners[:, 1:3] - corners[:, 0:2], 2, 0)) / 2
    beyond = np.abs(np.einsum("ik,iak->ia", point - centers, axes)) - halves
    distances: Array = np.hypot(*np.maximum(beyond, 0.0).T)
    return distances


def overlaps(ones: Array, others: Array, tolerance_m: float) -> Pairs:
    """Returns pairs of indices (k, 2): rectangles (n, 4, 2) that overlap shapes (m, 4 or 2, 2) by over `tolerance_m`.

    Separating axis theorem: two convex shapes are disjoint if their projections on an edge's normal are disjoint.
    """
    near = np.argwhere(_may_touch(ones, others, max(0.0, -tolerance_m)))
    one, other = ones[near[:, 0]], others[near[:, 1]]
    together = _shared(_axes(one), one, other, tolerance_m) & _shared(
        _axes(other), one, other, tolerance_m
    )
    found: Pairs = near[together]
    return found


def _may_touch(ones: Array, others: Array, gap_m: float) -> NDArray[np.bool_]:
    centers, reach = ones.mean(axis=1), _reach(ones)
    other_centers, other_reach = others.mean(axis=1), _reach(others)
    distances = np.hypot(*np.moveaxis(centers[:, None] - other_centers[None], 2, 0))
    near: NDArray[np.bool_] = distances < reach[:, None] + other_reach[None] + gap_m
    return near


def _reach(shapes: Array) -> Array:
    """Returns the circumradius (n) of each shape about the mean of its corners."""
    spread = shapes - shapes.mean(axis=1, keepdims=True)
    reach: Array = np.hypot(spread[..., 0], spread[..., 1]).max(axis=1)
    return reach


def _axes(shapes: Array) -> Array:
    """Returns unit vectors along and across the first edge of each shape: (n, 2, 2)."""
    along = shapes[:, 1] - shapes[:, 0]
    along = along / np.maximum(np.hypot(*along.T), 1e-12)[:, None]
    axes: Array = np.stack([along, np.stack([-along[:, 1], along[:, 0]], axis=1)], axis=1)
    return axes


def _shared(axes: Array, one: Array, other: Array, tolerance_m: float) -> NDArray[np.bool_]:
    """Returns whether the projections of both shapes on every axis overlap by more than the tolerance."""
    shadow = np.einsum("iak,ick->iac", axes, one)
    other_shadow = np.einsum("iak,ick->iac", axes, other)
    depth = np.minimum(
        shadow.max(axis=2) - other_shadow.min(axis=2), other_shadow.max(axis=2) - shadow.min(axis=2)
    )
    shared: NDArray[np.bool_] = (depth > tolerance_m).all(axis=1)
    return shared
