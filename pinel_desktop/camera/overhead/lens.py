"""The camera above the floor: where it hangs and how its lens distorts, estimated from the markers on the floor."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.camera.overhead.detection import Corners
from pinel_desktop.camera.overhead.markers import FLOOR_MARKERS, MARKER_M, OverheadSetup
from pinel_desktop.gestures.opencv import cv2

Vector = NDArray[np.float64]
_CAMERA_HEIGHT_SIGMA_M = 0.02  # of the height that a person measured
_PIXEL_SIGMA = 0.15  # of a detected corner
_MIDDLE_SIGMA_PX = 10.0  # by how much the axis of a webcam misses the middle of its picture
_K_SIGMA = np.array([0.3, 0.05])  # of the distortion of webcams, whose mean is none
_STEPS = 40
# places in the state: focal length, middle, distortion, rotation, translation, angles of the floor markers
_MIDDLE, _K, _ROTATION, _TRANSLATION = slice(1, 3), slice(3, 5), slice(5, 8), slice(8, 11)
_ANGLES = slice(11, 15)
_HALF = MARKER_M / 2
# as `Corners`: top left as printed, then clockwise seen from above; x to the right as printed, y up
SQUARE = np.array([[-_HALF, _HALF], [_HALF, _HALF], [_HALF, -_HALF], [-_HALF, -_HALF]])


@dataclass(frozen=True, slots=True)
class Lens:
    """A camera that looks at the floor.

    Attributes:
        matrix: intrinsic matrix (3, 3).
        distortion: radial, k1 and k2, then zeros for OpenCV.
        rotation, translation: from the floor's frame to the camera's, as Rodrigues vector and in m.
        error_m: how far the floor markers are seen from where they lie, root mean square, in m.
    """

    matrix: Vector
    distortion: Vector
    rotation: Vector
    translation: Vector
    error_m: float

    def project(self, points: Vector) -> Vector:
        """Returns the px (n, 2) at which points (n, 3) of the floor's frame are seen."""
        seen, _ = cv2.projectPoints(
            points, self.rotation, self.translation, self.matrix, self.distortion
        )
        return np.asarray(seen, np.float64).reshape(-1, 2)

    def on_plane(self, px: Vector, height_m: float) -> Vector:
        """Returns the places (n, 2), in m, at which the rays of px (n, 2) meet a level above the floor."""
        flat = cv2.undistortPoints(px.reshape(-1, 1, 2), self.matrix, self.distortion)
        turn = cv2.Rodrigues(self.rotation)[0]
        rays = np.column_stack([flat.reshape(-1, 2), np.ones(len(px))]) @ turn
        eye = -turn.T @ self.translation
        reach = (height_m - eye[2]) / rays[:, 2]
        return np.asarray((eye + rays * reach[:, None])[:, :2])

    @property
    def eye(self) -> Vector:
        """Where the lens is, in the floor's frame, in m."""
        return np.asarray(-cv2.Rodrigues(self.rotation)[0].T @ self.translation)


def estimate_lens(
    floor: dict[int, Corners], setup: OverheadSetup, size_px: tuple[int, int]
) -> Lens | None:
    """Estimates the lens by least squares from the corners of all four floor markers.

    Four markers in one plane seen from above do not tell focal length and height apart, so the measured height of the
    camera counts as an observation.

    Args:
        floor: corners by marker, best the means of several pictures.
        size_px: width and height of the picture.

    Returns:
        None if a marker is missing, or no camera at that height sees the markers so.
    """
    if any(number not in floor for number in FLOOR_MARKERS):
        return None
    seen = np.concatenate([floor[number] for number in FLOOR_MARKERS])
    state = _first_guess(floor, setup, size_px)
    if state is None:
        return None
    problem = _Problem(seen, setup, size_px)
    state = problem.solve(state)
    lens = problem.lens(state, 0.0)
    off = lens.on_plane(seen, 0.0) - problem.on_floor(state)
    error_m = float(np.sqrt(np.mean(np.sum(off**2, axis=1))))
    if not np.isfinite(error_m) or error_m > 0.1 or abs(lens.eye[2] - setup.camera_m) > 0.3:
        return None
    return problem.lens(state, error_m)


def _matrix(focal_px: float, off_middle: Vector, size_px: tuple[int, int]) -> Vector:
    """Returns the intrinsic matrix of a camera whose axis misses the middle of the picture by so many px."""
    x, y = (np.asarray(size_px) - 1) / 2 + off_middle
    return np.array([[focal_px, 0, x], [0, focal_px, y], [0, 0, 1]], np.float64)


class _Problem:
    """Least squares over camera and angles of the floor markers."""

    def __init__(self, seen: Vector, setup: OverheadSetup, size_px: tuple[int, int]) -> None:
        self._seen, self._setup, self._size_px = seen, setup, size_px

    def lens(self, state: Vector, error_m: float) -> Lens:
        matrix = _matrix(state[0], state[_MIDDLE], self._size_px)
        distortion = np.concatenate([state[_K], np.zeros(2)])
        return Lens(matrix, distortion, state[_ROTATION], state[_TRANSLATION], error_m)

    def on_floor(self, state: Vector) -> Vector:
        """Returns the corners (16, 2) on the floor."""
        return np.concatenate(
            [
                np.asarray(centre) + SQUARE @ _turn(angle).T
                for centre, angle in zip(self._setup.floor_centres, state[_ANGLES], strict=True)
            ]
        )

    def solve(self, state: Vector) -> Vector:
        """Levenberg and Marquardt's method."""
        damping, residuals = 1e-3, self._residuals(state)
        for _ in range(_STEPS):
            jacobian = self._jacobian(state, residuals)
            normal = jacobian.T @ jacobian
            step = np.linalg.solve(
                normal + damping * np.diag(np.diag(normal) + 1e-12), -jacobian.T @ residuals
            )
            better = self._residuals(state + step)
            if better @ better < residuals @ residuals:
                done = residuals @ residuals - better @ better < 1e-9
                state, residuals, damping = state + step, better, damping / 5
                if done:
                    break
            else:
                damping *= 5
        return state

    def _residuals(self, state: Vector) -> Vector:
        corners = np.column_stack([self.on_floor(state), np.zeros(16)])
        lens = self.lens(state, 0.0)
        return np.concatenate(
            [
                (lens.project(corners) - self._seen).ravel() / _PIXEL_SIGMA,
                [(lens.eye[2] - self._setup.camera_m) / _CAMERA_HEIGHT_SIGMA_M],
                state[_MIDDLE] / _MIDDLE_SIGMA_PX,
                state[_K] / _K_SIGMA,
            ]
        )

    def _jacobian(self, state: Vector, residuals: Vector) -> Vector:
        columns = []
        for place, value in enumerate(state):
            by = 1e-6 * max(1.0, abs(value))
            nudged = state.copy()
            nudged[place] += by
            columns.append((self._residuals(nudged) - residuals) / by)
        return np.column_stack(columns)


def _first_guess(
    floor: dict[int, Corners], setup: OverheadSetup, size_px: tuple[int, int]
) -> Vector | None:
    """Returns a camera without distortion, by the centres of the markers."""
    centres = np.array([floor[number].mean(axis=0) for number in FLOOR_MARKERS])
    places = np.column_stack([np.asarray(setup.floor_centres), np.zeros(4)])
    side_px = np.linalg.norm(centres - np.roll(centres, 1, axis=0), axis=1).mean()
    focal = side_px * setup.camera_m / ((setup.width_m + setup.depth_m) / 2)
    matrix = _matrix(focal, np.zeros(2), size_px)
    found, rotation, translation = cv2.solvePnP(
        places, centres, matrix, np.zeros(4), flags=cv2.SOLVEPNP_IPPE
    )
    turn, move = (np.asarray(one, np.float64).ravel() for one in (rotation, translation))
    flat = Lens(matrix, np.zeros(4), turn, move, 0.0)
    if not found or flat.eye[2] <= 0:  # the markers lie in another order
        return None
    angles = [heading_of(flat.on_plane(floor[number], 0.0)) for number in FLOOR_MARKERS]
    return np.concatenate([[focal], np.zeros(4), flat.rotation, flat.translation, angles])


def heading_of(corners: Vector) -> float:
    """Returns the angle, in rad, by which a marker's corners (4, 2) on a level are turned from `SQUARE`."""
    around = corners - corners.mean(axis=0)
    cross = np.sum(SQUARE[:, 0] * around[:, 1] - SQUARE[:, 1] * around[:, 0])
    return float(np.arctan2(cross, np.sum(SQUARE * around)))


def _turn(angle: float) -> Vector:
    cos, sin = np.cos(angle), np.sin(angle)
    return np.array([[cos, -sin], [sin, cos]])
