"""What a source of truth says about a run: bounds, order, interpolation, which source is best."""

import math

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import Pose2D
from pinel_desktop.runs.truth import (
    Source,
    TruePose,
    Truth,
    best_at_end,
    best_during_run,
    check_in_room,
    in_start_frame,
    moves_alike,
    read_truth,
    truths_of,
)
from storage import TruePoseRow, TruthRow


def row(tick: int | None, x: float = 0.0, heading: float = 0.0, sigma: float = 0.01) -> TruePoseRow:
    return tick, x, 0.0, heading, sigma, 0.03


def truth(source: Source, *rows: TruePoseRow) -> Truth:
    found = read_truth(source, rows)
    assert found
    return found


def test_a_pose_between_two_is_on_the_line_and_turns_the_shorter_way() -> None:
    camera = truth("camera", row(10, 1.0, 3.0), row(14, 2.0, -3.0))
    between = camera.at(12)
    assert between
    assert between.pose.x_m == pytest.approx(1.5)
    assert abs(between.pose.yaw_rad) == pytest.approx(math.pi)
    assert camera.at(14) == camera.poses[1]


def test_nothing_is_known_before_after_and_where_the_robot_was_lost_for_half_a_second() -> None:
    camera = truth("camera", row(10), row(12), row(60), row(None))
    assert [camera.at(tick) is None for tick in (9, 11, 30, 60, 61)] == [
        True,
        False,
        True,
        False,
        True,
    ]


@pytest.mark.parametrize(
    ("value", "field"),
    [
        (row(None, x=101.0), "x_m"),
        (row(None, x=math.nan), "x_m"),
        (row(None, sigma=0.0), "sigma_m"),
        (row(-1), "tick"),
    ],
)
def test_a_value_out_of_bounds_is_named(value: TruePoseRow, field: str) -> None:
    with pytest.raises(PinelError) as error:
        read_truth("tape", [value])
    assert (error.value.code, error.value.params["field"]) == ("truth_range", field)


@pytest.mark.parametrize("ticks", [(3, 2), (3, 3), (None, 4), (None, None)])
def test_poses_are_in_the_order_of_time(ticks: tuple[int | None, int | None]) -> None:
    with pytest.raises(PinelError, match="truth_order"):
        read_truth("camera", [row(tick) for tick in ticks])


def test_no_poses_are_no_truth() -> None:
    assert read_truth("tape", []) is None


def test_a_heading_of_more_than_half_a_turn_is_the_same_heading() -> None:
    turned = truth("tape", row(None, heading=1.5 * math.pi))
    assert turned.end.pose.yaw_rad == pytest.approx(-math.pi / 2)


def test_what_is_stored_is_read_back() -> None:
    camera = truth("camera", row(1, 0.5), row(None, 1.0))
    rows = TruthRow("r", "camera", "", tuple(camera.as_rows()))
    assert truths_of([rows]) == [camera]


def test_a_path_is_compared_with_the_camera_and_an_end_with_who_knows_it_best() -> None:
    tape = truth("tape", row(None, sigma=0.01))
    own = truth("localisation", row(1, sigma=0.05), row(9, sigma=0.05))
    camera = truth("camera", row(1, sigma=0.02), row(9, sigma=0.02))
    assert best_during_run([tape, own, camera]) == camera
    assert best_during_run([tape]) is None
    assert best_at_end([own, camera, tape]) == tape
    assert best_at_end([]) is None


def test_a_pose_far_outside_of_the_room_is_refused() -> None:
    start = Pose2D(1.0, 0.0, math.pi / 2)  # looks along the depth
    check_in_room(Pose2D(2.5, 0.0, 0.0), start, 4.0, 4.0)
    with pytest.raises(PinelError, match="truth_outside_room"):
        check_in_room(Pose2D(3.1, 0.0, 0.0), start, 4.0, 4.0)


def test_poses_of_a_map_are_aligned_to_the_start_by_the_first_estimate() -> None:
    start = Pose2D(4.0, -2.0, 1.2)
    way = [Pose2D(0.1 * n, 0.02 * n, 0.05 * n) for n in range(20)]
    seen = [TruePose(5 + n, start.compose(pose), 0.004, 0.01) for n, pose in enumerate(way)]
    aligned = in_start_frame(seen, lambda tick: way[tick - 5] if tick < 20 else None)
    assert [one.tick for one in aligned] == list(range(5, 25))
    for one, pose in zip(aligned, way, strict=True):
        assert one.pose == pytest.approx(pose, abs=1e-9)
    assert aligned[-1].sigma_m > aligned[0].sigma_m


def test_nothing_is_known_of_the_start_without_the_estimate_of_the_robot() -> None:
    assert in_start_frame([TruePose(1, Pose2D(), 0.01, 0.01)], lambda tick: None) == []


@pytest.mark.parametrize(
    ("seen", "is_alike"),
    [
        (Pose2D(1.0, 0.0, 0.0), True),
        (Pose2D(1.4, 0.0, 0.0), True),  # a fifth of the way, and 30 cm
        (Pose2D(1.6, 0.0, 0.0), False),
        (Pose2D(1.0, 0.0, math.radians(15)), True),
        (Pose2D(1.0, 0.0, math.radians(30)), False),
    ],
)
def test_a_movement_that_the_robot_does_not_believe_is_not_alike(
    seen: Pose2D, is_alike: bool
) -> None:
    start = Pose2D(2.0, 1.0, math.pi / 2)  # of the map: the frame does not count
    before, after = (start, Pose2D()), (start.compose(seen), Pose2D(1.0, 0.0, 0.0))
    assert moves_alike(before, after) is is_alike
