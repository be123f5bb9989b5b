"""Renders what a camera above the floor sees: printed markers at known poses, with lens, blur, light and noise."""

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.camera.overhead.markers import (
    FLOOR_MARKERS,
    MARKER_BITS,
    MARKER_M,
    ROBOT_MARKER,
    OverheadSetup,
)
from pinel_desktop.gestures.opencv import cv2
from pinel_desktop.gestures.pictures import Picture
from pinel_desktop.robot import Pose2D

SHEET_M = 0.20  # side of the white paper around the black square
_TEXTURE_PX = 400  # of a sheet's side
_FINE = 2  # rendered px per px, along each axis
_MARGIN_PX = 8  # fine px: a sheet's edges are curved between its corners
SIZE_PX = (1280, 720)


def sheet(number: int) -> NDArray[np.float32]:
    """A printed sheet: white paper with the marker in its middle, 0 to 1."""
    bits = np.zeros((6, 6), np.float32)
    bits[1:5, 1:5] = [[float(bit) for bit in row] for row in MARKER_BITS[number]]
    side = round(_TEXTURE_PX * MARKER_M / SHEET_M)
    marker = cv2.resize(bits, (side, side), interpolation=cv2.INTER_NEAREST)
    rest = _TEXTURE_PX - side
    return np.pad(marker, ((rest // 2, rest - rest // 2),) * 2, constant_values=1.0)


@dataclass
class Scene:
    """A camera over a floor.

    Attributes:
        tilt: of the camera, rad about x and y, and its turn about its axis.
        eye: of the lens, m, in the frame of the floor.
        middle_px: by how much the axis misses the middle of the picture.
        angles: of the floor markers as they lie, rad.
        light: brightness at the left and at the right.
    """

    setup: OverheadSetup = field(default_factory=OverheadSetup)
    eye: tuple[float, float, float] = (1.5, 1.5, 2.7)
    tilt: tuple[float, float, float] = (0.0, 0.0, 0.0)
    focal_px: float = 540.0
    distortion: tuple[float, float, float, float] = (-0.08, 0.01, 0.0, 0.0)
    middle_px: tuple[float, float] = (0.0, 0.0)
    angles: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    blur_px: float = 0.6
    noise: float = 3.0
    light: tuple[float, float] = (1.0, 1.0)
    hidden: frozenset[int] = frozenset()
    seed: int = 1

    def __post_init__(self) -> None:
        self._chance = np.random.default_rng(self.seed)
        self._still: NDArray[np.float32] | None = None

    def picture(self, robot: Pose2D | None) -> Picture:
        """What the camera sees, with the robot's marker at a pose of the floor's frame."""
        if self._still is None:
            self._still = self._floor()
        seen = self._still.copy()
        if robot:
            self._lay(seen, ROBOT_MARKER, robot._replace(yaw_rad=robot.yaw_rad - math.pi / 2),
                      self.setup.robot_m)  # fmt: skip
        return self._developed(seen)

    def _floor(self) -> NDArray[np.float32]:
        width, height = SIZE_PX
        seen = np.full((_FINE * height, _FINE * width), 0.55, np.float32)
        for number in FLOOR_MARKERS:
            if number not in self.hidden:
                x, y = self.setup.floor_centres[number]
                self._lay(seen, number, Pose2D(x, y, self.angles[number]), 0.0)
        return seen

    def _lay(self, seen: NDArray[np.float32], number: int, pose: Pose2D, level_m: float) -> None:
        """Draws a sheet that lies at a pose on a level above the floor."""
        part = self._part_of_sheet(pose, level_m)
        rays = self._rays(part)
        reach = (level_m - self.eye[2]) / rays[..., 2]
        x = self.eye[0] + reach * rays[..., 0] - pose.x_m
        y = self.eye[1] + reach * rays[..., 1] - pose.y_m
        cos, sin = math.cos(pose.yaw_rad), math.sin(pose.yaw_rad)
        right, up = cos * x + sin * y, cos * y - sin * x
        on = (np.abs(right) < SHEET_M / 2) & (np.abs(up) < SHEET_M / 2)
        if not on.any():
            return
        scale = _TEXTURE_PX / SHEET_M
        column = (right * scale + _TEXTURE_PX / 2 - 0.5).astype(np.float32)
        row = (_TEXTURE_PX / 2 - up * scale - 0.5).astype(np.float32)
        drawn = cv2.remap(sheet(number), column, row, cv2.INTER_LINEAR)
        seen[part] = np.where(on, drawn, seen[part])

    def _part_of_sheet(self, pose: Pose2D, level_m: float) -> tuple[slice, slice]:
        """The fine rows and columns in which a sheet lies, with a margin."""
        reach = SHEET_M / math.sqrt(2)  # from the middle to a corner
        angles = pose.yaw_rad + math.pi * np.array([0.25, 0.75, 1.25, 1.75])
        corners = np.stack(
            [pose.x_m + reach * np.cos(angles), pose.y_m + reach * np.sin(angles), np.full(4, level_m)],
            axis=-1,
        )  # fmt: skip
        from_lens = (corners - self.eye) @ self._turn().T
        still = np.zeros(3)
        px, _ = cv2.projectPoints(
            from_lens, still, still, self._matrix(), np.array(self.distortion)
        )
        fine = (px.reshape(4, 2) + 0.5) * _FINE
        limit = np.array(SIZE_PX) * _FINE
        first = np.clip(np.floor(fine.min(axis=0)) - _MARGIN_PX, 0, limit).astype(int)
        last = np.clip(np.ceil(fine.max(axis=0)) + _MARGIN_PX, 0, limit).astype(int)
        return slice(first[1], last[1]), slice(first[0], last[0])

    def _matrix(self) -> NDArray[np.float64]:
        width, height = SIZE_PX
        return np.array(
            [
                [self.focal_px, 0, (width - 1) / 2 + self.middle_px[0]],
                [0, self.focal_px, (height - 1) / 2 + self.middle_px[1]],
                [0, 0, 1],
            ]
        )

    def _rays(self, part: tuple[slice, slice]) -> NDArray[np.float64]:
        """The direction in which each fine px of a part looks, in the floor's frame."""
        rows, columns = ((np.arange(one.start, one.stop) + 0.5) / _FINE - 0.5 for one in part)
        px = np.stack(np.meshgrid(columns, rows), axis=-1).reshape(-1, 1, 2)
        if not len(px):
            return np.ones((len(rows), len(columns), 3))
        criteria = (cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 30, 1e-9)
        flat = cv2.undistortPointsIter(
            px, self._matrix(), np.array(self.distortion), np.eye(3), np.eye(3), criteria
        ).reshape(len(rows), len(columns), 2)
        rays = np.concatenate([flat, np.ones((*flat.shape[:2], 1))], axis=-1)
        return np.asarray(rays @ self._turn())

    def _turn(self) -> NDArray[np.float64]:
        """From the floor's frame to the camera's, which looks down; its picture has x to the right, y down."""
        down = np.array([[1.0, 0, 0], [0, -1.0, 0], [0, 0, -1.0]])
        about_x, about_y, about_z = self.tilt
        turns = [
            cv2.Rodrigues(np.array(axis) * angle)[0]
            for axis, angle in (((1.0, 0, 0), about_x), ((0, 1.0, 0), about_y), ((0, 0, 1.0), about_z))
        ]  # fmt: skip
        return np.asarray(turns[0] @ turns[1] @ turns[2] @ down)

    def _developed(self, seen: NDArray[np.float32]) -> Picture:
        """Blurs, lights and exposes the picture."""
        small = cv2.resize(seen, SIZE_PX, interpolation=cv2.INTER_AREA)
        if self.blur_px:
            small = cv2.GaussianBlur(small, (0, 0), self.blur_px)
        left, right = self.light
        exposed = small * np.linspace(left, right, SIZE_PX[0], dtype=np.float32) * 200.0 + 20.0
        grey = exposed + self._chance.normal(0.0, self.noise, exposed.shape)
        return np.repeat(np.clip(grey, 0, 255).astype(np.uint8)[..., None], 3, axis=-1)
