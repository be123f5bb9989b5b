"""The presets: an ideal robot follows commands exactly, a realistic one within bounds."""

import math
import random
from pathlib import Path

import pytest

from pinel_desktop.execution.executor import RunOptions, RunResult, execute
from pinel_desktop.links import open_link
from pinel_desktop.links.sim import SimLink
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import ROBOTS, Pose2D, RobotLink, SimulationConfig, Twist2D
from sim.simulator import TICK_S

PROGRAMS = Path(__file__).parents[1] / "programs"
POSE_FEEDBACK = SimulationConfig(preset="realistic", feedback="pose")
ODOMETRY_FEEDBACK = SimulationConfig(preset="realistic", feedback="odometry")


def run(
    setting: SimulationConfig, seed: int, program: str = "square", world: str = "empty_room"
) -> tuple[RunResult, Pose2D]:
    """The run of a program, and where it really ends in the start frame."""
    read = read_document((PROGRAMS / f"{program}.json").read_bytes()).program
    assert read is not None
    link = open_link("sim", world=world, setting=setting, seed=seed)
    start = true_pose(link)
    result = execute(read, link, RunOptions(seed=seed, robot=setting.robot))
    return result, true_pose(link).relative_to(start)


def true_pose(link: RobotLink) -> Pose2D:
    pose = link.read().true_pose
    assert pose is not None
    return pose


def p95(values: list[float]) -> float:
    return sorted(values)[math.ceil(0.95 * len(values)) - 1]


def closing_errors(setting: SimulationConfig) -> tuple[float, float]:
    """95th percentiles over 20 seeds: how far from the start, in m, and how much turned, in degrees, a square ends."""
    runs = [run(setting, seed) for seed in range(20)]
    assert {result.ended.state for result, _ in runs} == {"finished"}
    distances = [math.hypot(end.x_m, end.y_m) for _, end in runs]
    return p95(distances), p95([abs(math.degrees(end.yaw_rad)) for _, end in runs])


def test_square_of_a_robot_that_knows_its_pose_closes_within_5_mm() -> None:
    distance_m, heading_deg = closing_errors(POSE_FEEDBACK)
    print(f"closing error p95 over 20 seeds: {distance_m * 1e3:.1f} mm, {heading_deg:.2f} degrees")
    assert distance_m < 0.005
    assert heading_deg < 0.3


def test_square_of_a_robot_that_knows_its_wheels_only_drifts_for_all_to_see() -> None:
    distance_m, heading_deg = closing_errors(ODOMETRY_FEEDBACK)
    assert 0.02 < distance_m < 0.3
    assert heading_deg > 1.0


def test_robot_that_knows_its_wheels_only_believes_that_all_is_well() -> None:
    result, end = run(ODOMETRY_FEEDBACK, seed=4)
    assert result.ended.estimated_closing_error_m is not None
    assert result.ended.estimated_closing_error_m < 0.01
    assert math.hypot(end.x_m, end.y_m) > 3 * result.ended.estimated_closing_error_m


@pytest.mark.parametrize("model", ROBOTS)
def test_ideal_square_of_every_robot_closes(model: str) -> None:
    result, end = run(SimulationConfig(model=model), seed=0)
    assert result.ended.state == "finished"
    assert math.hypot(end.x_m, end.y_m) < 1e-4
    assert abs(math.degrees(end.yaw_rad)) < 0.02


@pytest.mark.parametrize("feedback", ["pose", "odometry"])
def test_ideal_robot_knows_its_true_pose_by_whatever_feedback(feedback: str) -> None:
    link = open_link("sim", world="empty_room", setting=SimulationConfig(feedback=feedback))  # type: ignore[arg-type]
    for _ in range(30):
        link.command(Twist2D(0.5, 0.5))
        link.advance(TICK_S)
    state = link.read()
    assert state.pose == state.true_pose


@pytest.mark.parametrize("setting", [POSE_FEEDBACK, ODOMETRY_FEEDBACK])
def test_realistic_run_is_the_same_again_and_another_with_another_seed(
    setting: SimulationConfig,
) -> None:
    first, again, other = (run(setting, seed)[0].ended.telemetry_sha256 for seed in (7, 7, 8))
    assert first == again != other


def test_what_sensors_are_read_does_not_change_a_realistic_run() -> None:
    def poses(reads: bool) -> list[Pose2D]:
        link, draw = SimLink(world="obstacles", setting=POSE_FEEDBACK, seed=3), random.Random(1)
        recorded = []
        for tick in range(150):
            link.command(Twist2D(0.4, math.sin(tick / 10)))
            link.advance(TICK_S)
            if reads and draw.random() < 0.5:
                link.sensors.sonar(draw.randrange(16))
                link.sensors.scan()
            recorded.append(link.read().pose)
        return recorded

    assert poses(reads=True) == poses(reads=False)


def test_reading_again_within_a_tick_gives_the_same() -> None:
    link = SimLink(world="obstacles", setting=POSE_FEEDBACK, seed=3)
    link.command(Twist2D(0.4, 0.2))
    link.advance(TICK_S)
    assert link.read() == link.read()
    assert link.sensors.scan() == link.sensors.scan()
    assert link.sensors.scan()[90] == pytest.approx(link.sensors.lidar(0.0), abs=1e-6)
    assert link.sensors.sonars()[3] == pytest.approx(link.sensors.sonar(3), abs=1e-9)


def test_sensors_err_a_little_and_stay_in_their_range() -> None:
    exact = SimLink(world="obstacles", setting=SimulationConfig(), seed=3).sensors
    link = SimLink(world="obstacles", setting=POSE_FEEDBACK, seed=3)
    errors = []
    for _ in range(100):
        link.advance(TICK_S)  # it stands, and measures anew
        errors.append(link.sensors.sonar(7) - exact.sonar(7))
        assert max(link.sensors.scan()) <= 8.0
    assert 0.0 < max(map(abs, errors)) < 0.035 * exact.sonar(7)
    assert abs(sum(errors) / len(errors)) < 0.01


def test_realistic_robot_starts_where_it_is_put_and_stands_until_it_is_told() -> None:
    link = SimLink(world="obstacles", setting=POSE_FEEDBACK, seed=3)
    start = link.read()
    assert start.pose == start.true_pose
    for _ in range(30):
        link.advance(TICK_S)
    assert true_pose(link) == start.true_pose


def test_command_takes_its_time_to_the_wheels() -> None:
    link = SimLink(world="empty_room", setting=ODOMETRY_FEEDBACK, seed=1)
    link.command(Twist2D(0.5, 0.0))
    link.advance(TICK_S)
    assert true_pose(link).x_m == 0.0
    for _ in range(29):
        link.advance(TICK_S)
    # as late as the link says that it is, within the slip
    assert true_pose(link).x_m == pytest.approx(0.5 * (1.0 - link.command_delay_s), rel=0.03)


def test_wheels_that_are_blocked_count_nothing() -> None:
    link = SimLink(world="empty_room", setting=ODOMETRY_FEEDBACK, seed=1)
    for _ in range(400):
        link.command(Twist2D(1.0, 0.0))
        link.advance(TICK_S)
    state = link.read()
    assert link.bumper()
    assert state.pose.x_m == pytest.approx(true_pose(link).x_m, abs=0.1)
    assert abs(state.twist.v_mps) < 0.05  # its wheels turn it a little, and it slides along


@pytest.mark.parametrize("feedback", ["pose", "odometry"])
def test_realistic_robot_that_is_blocked_says_so(feedback: str) -> None:
    setting = SimulationConfig(preset="realistic", feedback=feedback)  # type: ignore[arg-type]
    result, _ = run(setting, 2, "into_the_wall")
    assert (result.ended.state, result.ended.reason) == ("failed", "blocked")
