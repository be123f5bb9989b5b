"""The robot's pose in rendered pictures of known poses, and what is said of a lost, covered or moved camera."""

import math
from dataclasses import replace

import numpy as np

from pinel_desktop.camera.overhead.markers import OverheadSetup
from pinel_desktop.camera.overhead.tracking import OverheadTracker, Sighting
from pinel_desktop.gestures.pictures import Picture
from pinel_desktop.robot import Pose2D, wrap_angle
from tests.camera.overhead.rendering import SIZE_PX, Scene

MIDDLE = Pose2D(1.5, 1.5, 0.5)
FRAME_S = 1 / 15


def calibrated(scene: Scene) -> OverheadTracker:
    tracker = OverheadTracker(scene.setup)
    for n in range(8):
        tracker.update(n * FRAME_S, scene.picture(None))
    assert tracker.lens
    return tracker


def varied(seed: int) -> Scene:
    """A webcam as somebody hangs it up: lens, tilt, blur, light and noise by chance, the height measured to 2 cm."""
    chance = np.random.default_rng(seed)
    return Scene(
        eye=(*chance.uniform(1.3, 1.7, 2), 2.7 + chance.uniform(-0.02, 0.02)),
        tilt=(*chance.uniform(-0.05, 0.05, 2), chance.uniform(-0.1, 0.1)),
        focal_px=chance.uniform(495, 515),
        distortion=(chance.uniform(-0.15, 0.03), *chance.uniform(-5e-4, 0.01, 1), 2e-4, -3e-4),
        middle_px=tuple(chance.uniform(-8, 8, 2)),
        angles=tuple(chance.uniform(-0.1, 0.1, 4)),
        blur_px=chance.uniform(0.3, 1.0),
        noise=chance.uniform(2, 6),
        light=tuple(chance.uniform(0.5, 1, 2)),
        seed=seed,
    )


def test_the_pose_is_right_to_a_centimetre_and_a_degree_in_three_by_three_metres() -> None:
    off_m, off_deg, sigmas = [], [], []
    for seed in range(5):
        scene, chance = varied(seed), np.random.default_rng(100 + seed)
        tracker = calibrated(scene)
        for n in range(8):
            x, y = chance.uniform(0.3, 2.7, 2)
            pose = Pose2D(x, y, chance.uniform(-3, 3))
            seen = tracker.update(1 + n * FRAME_S, scene.picture(pose)).seen
            assert seen, (seed, pose)
            off_m.append(seen.pose.distance_to(pose))
            off_deg.append(math.degrees(abs(wrap_angle(seen.pose.yaw_rad - pose.yaw_rad))))
            sigmas.append(off_m[-1] / seen.sigma_m)
    figures = [
        np.percentile(values, (50, 95, 100)).round(4).tolist() for values in (off_m, off_deg)
    ]
    print("m, degrees: p50, p95, max", figures)
    assert max(off_m) < 0.01
    assert max(off_deg) < 1.0
    assert np.percentile(sigmas, 90) < 2.15  # 90 of 100 of two coordinates


def test_the_height_of_the_marker_above_the_floor_is_accounted_for() -> None:
    """Near the edge a marker 25 cm above the floor is seen 15 cm from where it is."""
    scene = Scene(distortion=(0, 0, 0, 0))
    flat = OverheadTracker(scene.setup.model_copy(update={"robot_m": 0.0}))
    right = calibrated(scene)
    edge = Pose2D(2.8, 1.5, 0.0)
    for n in range(9):
        sighting = flat.update(n * FRAME_S, scene.picture(edge))
    assert sighting.seen
    assert sighting.seen.pose.distance_to(edge) > 0.1
    seen = right.update(1, scene.picture(edge)).seen
    assert seen
    assert seen.pose.distance_to(edge) < 0.01


def test_floor_markers_that_are_missing_are_named() -> None:
    scene = Scene(hidden=frozenset({1, 2}))
    sighting = OverheadTracker(scene.setup).update(0, scene.picture(MIDDLE))
    assert sighting == Sighting(None, "overhead_floor_missing", (2, 3), (1, 4, 5))


def test_impossible_measurements_are_reported() -> None:
    scene = Scene()
    tracker = OverheadTracker(OverheadSetup(width_m=3, depth_m=1.5))
    for n in range(9):
        sighting = tracker.update(n * FRAME_S, scene.picture(None))
    assert sighting.problem == "overhead_setup_wrong"


def test_a_covered_robot_is_told_after_half_a_second() -> None:
    scene = Scene()
    tracker = calibrated(scene)
    assert tracker.update(1.0, scene.picture(MIDDLE)).seen
    assert tracker.update(1.3, scene.picture(None)) == Sighting(None, markers=(1, 2, 3, 4))
    assert tracker.update(1.6, scene.picture(None)).problem == "overhead_covered"
    assert tracker.update(1.7, scene.picture(MIDDLE)).seen


def test_a_robot_outside_the_picture_is_reported() -> None:
    scene = Scene(eye=(1.5, 1.5, 2.2), setup=OverheadSetup(width_m=2.4, depth_m=2.4, camera_m=2.2))
    tracker = calibrated(replace(scene, eye=(1.2, 1.2, 2.2)))
    scene = replace(scene, eye=(1.2, 1.2, 2.2))
    assert tracker.update(1.0, scene.picture(Pose2D(1.2, 2.35, 0.0))).seen
    assert tracker.update(2.0, scene.picture(None)).problem == "overhead_left"


def test_a_moved_camera_is_reported_and_its_poses_are_right_again_in_the_same_frame() -> None:
    scene = Scene()
    tracker = calibrated(scene)
    moved = replace(scene, eye=(1.55, 1.45, 2.7), tilt=(0.02, 0.0, 0.05))
    sightings = [tracker.update(1 + n * FRAME_S, moved.picture(MIDDLE)) for n in range(3)]
    assert all(one.seen is None for one in sightings)
    assert sightings[-1].problem == "overhead_moved"
    for n in range(9):
        last = tracker.update(2 + n * FRAME_S, moved.picture(MIDDLE))
    assert last.seen
    assert last.seen.pose.distance_to(MIDDLE) < 0.01


def test_a_floor_marker_that_somebody_kicked_is_told() -> None:
    scene = Scene()
    tracker = calibrated(scene)
    pushed = replace(scene, setup=_Kicked())
    for n in range(3):
        sighting = tracker.update(1 + n * FRAME_S, pushed.picture(MIDDLE))
    assert sighting == Sighting(None, "overhead_marker_moved", (3,), (1, 2, 3, 4, 5))


class _Kicked(OverheadSetup):
    """Floor marker 3 lies 8 cm from where it was."""

    @property
    def floor_centres(self) -> tuple[tuple[float, float], ...]:
        first, second, (x, y), fourth = super().floor_centres
        return first, second, (x - 0.08, y), fourth


def test_a_dark_picture_has_no_pose() -> None:
    scene = Scene()
    tracker = calibrated(scene)
    dark: Picture = np.zeros((SIZE_PX[1], SIZE_PX[0], 3), np.uint8)
    assert tracker.update(2.0, dark).problem == "overhead_covered"
