"""What counts as a jump: poses that no robot can have reached from the report before, in a time that the test makes."""

import math
from dataclasses import dataclass
from random import Random

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.links.odometry import OdometryFilter
from pinel_desktop.links.transport import Odometry
from pinel_desktop.robot import STANDSTILL, Pose2D, Twist2D

AHEAD, BACK = Twist2D(0.3, 0.0), Twist2D(-0.3, 0.0)
LEFT = Twist2D(0.0, math.radians(60.0))
RATES_HZ = [1.2, 2.0, 2.5, 5.0, 10.0, 30.0, 50.0]
_STEP_S, _LONG_S = 0.01, 40.0


class Robot:
    """A unicycle that follows a velocity at once."""

    def __init__(self) -> None:
        self.pose = Pose2D()

    def move(self, twist: Twist2D, seconds: float) -> None:
        middle = Pose2D(yaw_rad=twist.omega_radps * seconds / 2)
        step = middle.compose(Pose2D(twist.v_mps * seconds, 0.0, middle.yaw_rad))
        self.pose = self.pose.compose(step)


def report(pose: Pose2D) -> Odometry:
    return Odometry(*pose, v_mps=None, omega_radps=None)


def driven(twist: Twist2D, rate_hz: float, seconds: float) -> tuple[OdometryFilter, Robot, float]:
    """A robot that is commanded a velocity for so long and reports what it does: and when it reported last."""
    checked, robot = OdometryFilter(), Robot()
    checked.command(STANDSTILL, 0.0)
    checked.command(twist, 5.0)
    checked.add(report(robot.pose), 5.0)
    n_reports = math.ceil(seconds * rate_hz)
    for number in range(1, n_reports + 1):
        robot.move(twist, seconds / n_reports)
        checked.add(report(robot.pose), 5.0 + number * seconds / n_reports)
    return checked, robot, 5.0 + seconds


def is_jump(checked: OdometryFilter, pose: Pose2D, now_s: float) -> bool:
    try:
        checked.add(report(pose), now_s)
    except PinelError as problem:
        return problem.code == "reference_lost"
    return False


@pytest.mark.parametrize("away_s", [0.03, 0.4, 0.7, 1.0])
@pytest.mark.parametrize("rate_hz", RATES_HZ)
@pytest.mark.parametrize("distance_m", [0.3, 1.0])
def test_a_pose_that_is_zero_again_is_a_jump_where_the_robot_drove_ahead(
    distance_m: float, rate_hz: float, away_s: float
) -> None:
    checked, _, now_s = driven(AHEAD, rate_hz, distance_m / AHEAD.v_mps)
    assert is_jump(checked, Pose2D(), now_s + away_s)


@pytest.mark.parametrize("away_s", [0.03, 0.4, 0.7, 1.0])
@pytest.mark.parametrize("rate_hz", RATES_HZ)
def test_a_robot_that_stood_still_meanwhile_is_where_it_was(rate_hz: float, away_s: float) -> None:
    checked, robot, now_s = driven(AHEAD, rate_hz, 1.0)
    assert not is_jump(checked, robot.pose, now_s + away_s)
    robot.move(AHEAD, away_s)
    assert not is_jump(checked, robot.pose, now_s + 2 * away_s)


@pytest.mark.parametrize("rate_hz", RATES_HZ)
@pytest.mark.parametrize(
    ("twist", "jump"),
    [
        (AHEAD, Pose2D(1.0)),
        (AHEAD, Pose2D(-0.6)),
        (AHEAD, Pose2D(0.0, 0.4)),
        (AHEAD, Pose2D(yaw_rad=math.radians(45.0))),
        (BACK, Pose2D(0.6)),
        (BACK, Pose2D(-1.0)),
        (LEFT, Pose2D(yaw_rad=math.radians(-90.0))),
        (LEFT, Pose2D(yaw_rad=math.radians(150.0))),
        (LEFT, Pose2D(0.3)),
        (STANDSTILL, Pose2D(0.3)),
        (STANDSTILL, Pose2D(yaw_rad=math.radians(30.0))),
    ],
)
def test_what_the_commanded_velocity_does_not_allow_is_a_jump_at_every_rate(
    twist: Twist2D, jump: Pose2D, rate_hz: float
) -> None:
    checked, robot, now_s = driven(twist, rate_hz, 4.0)
    robot.move(twist, 1 / rate_hz)
    assert is_jump(checked, robot.pose.compose(jump), now_s + 1 / rate_hz)


@pytest.mark.parametrize(
    ("rate_hz", "gap_s", "ahead_m", "back_m", "turned_deg"),
    [(30.0, 1 / 30, 0.17, 0.10, 15), (2.0, 0.5, 0.45, 0.15, 22.5), (30.0, 1.0, 0.56, 0.20, 30)],
)
def test_the_bound_is_that_of_the_page_about_robots(
    rate_hz: float, gap_s: float, ahead_m: float, back_m: float, turned_deg: float
) -> None:
    bounds = [Pose2D(ahead_m), Pose2D(-back_m), Pose2D(0.0, 0.0, math.radians(turned_deg))]
    for bound in bounds:
        for factor, is_beyond in ((0.95, False), (1.08, True)):
            checked, robot, now_s = driven(AHEAD, rate_hz, 2.0)
            step = Pose2D(*(factor * each for each in bound))
            assert is_jump(checked, robot.pose.compose(step), now_s + gap_s) == is_beyond


def test_a_jump_over_the_half_turn_is_none() -> None:
    for side in (1.0, -1.0):
        checked = OdometryFilter()
        checked.command(STANDSTILL, 0.0)
        checked.add(report(Pose2D(yaw_rad=side * math.radians(179.5))), 5.0)
        assert not is_jump(checked, Pose2D(yaw_rad=-side * math.radians(179.5)), 5.1)


def test_before_the_first_command_anybody_may_drive_the_robot() -> None:
    checked, robot = OdometryFilter(), Robot()
    checked.add(report(robot.pose), 0.0)
    for number in range(1, 20):
        robot.move(Twist2D(-1.2, 3.0), 0.5)
        assert not is_jump(checked, robot.pose, number * 0.5)
    assert is_jump(checked, robot.pose.compose(Pose2D(2.0)), 10.0)


@dataclass(frozen=True)
class Honest:
    """A robot that tells the truth, as late and as coarsely as networks and clients do.

    Attributes:
        rate_hz: how often it reports, and asks for a velocity that it then follows until it asks again.
        jitter_s: reports are up to so late.
        lost: part of the reports and of the velocities that never come.
        lag_s: time constant of its drives.
        burst_s: its reports arrive together each so often.
        grid_m: its pose is told in steps of so much, its yaw in steps of a degree.
        slip: part of the way that it does not drive, or drives too far where negative.
        push: somebody pushes it meanwhile.
    """

    rate_hz: float
    jitter_s: float = 0.0
    lost: float = 0.0
    lag_s: float = 0.06
    burst_s: float = 0.0
    grid_m: float = 0.0
    slip: float = 0.0
    push: Twist2D = STANDSTILL


def drives(draw: Random, v_mps: float, omega_radps: float) -> list[tuple[float, Twist2D]]:
    """Commands, each from when: drives, turns, curves and stops at up to these speeds."""
    commands, at_s = [(0.0, STANDSTILL)], 1.0
    while at_s < _LONG_S:
        v, omega = draw.choice([-v_mps, 0.0, v_mps]), draw.choice([-omega_radps, 0.0, omega_radps])
        commands.append((at_s, Twist2D(v * draw.random(), omega * draw.random())))
        at_s += draw.choice([0.03, 0.3, 1.0, 3.0])
    return commands


def reports_of(
    robot: Honest, commands: list[tuple[float, Twist2D]], draw: Random
) -> list[tuple[float, Pose2D]]:
    """What it reports, each with when it arrives."""
    truth, twist, goal = Robot(), STANDSTILL, STANDSTILL
    due_s, number, arrived_s, reports = draw.random() / robot.rate_hz, 0, 0.0, []
    for tick in range(int(_LONG_S / _STEP_S)):
        now_s = tick * _STEP_S
        while number + 1 < len(commands) and commands[number + 1][0] <= now_s:
            number += 1
        part = min(1.0, _STEP_S / max(robot.lag_s, _STEP_S))
        twist = Twist2D(*(is_ + (to - is_) * part for is_, to in zip(twist, goal, strict=True)))
        truth.move(Twist2D(*(speed * (1 - robot.slip) for speed in twist)), _STEP_S)
        truth.move(robot.push, _STEP_S)
        if now_s >= due_s:
            due_s += 1 / robot.rate_hz
            if draw.random() >= robot.lost:
                goal = commands[number][1]
            if draw.random() >= robot.lost:
                late_s = now_s + robot.jitter_s * draw.random()
                if robot.burst_s:
                    late_s = math.ceil(now_s / robot.burst_s) * robot.burst_s
                arrived_s = max(arrived_s, late_s)
                reports.append((arrived_s, coarse(truth.pose, robot.grid_m)))
    return reports


def coarse(pose: Pose2D, grid_m: float) -> Pose2D:
    if not grid_m:
        return pose
    degree = math.radians(round(math.degrees(pose.yaw_rad)))
    return Pose2D(round(pose.x_m / grid_m) * grid_m, round(pose.y_m / grid_m) * grid_m, degree)


HONEST = [
    *(Honest(rate_hz) for rate_hz in RATES_HZ),
    *(Honest(rate_hz, jitter_s=0.1, lost=0.02) for rate_hz in RATES_HZ),
    *(Honest(rate_hz, lag_s=0.3, slip=0.1) for rate_hz in RATES_HZ),
    *(Honest(rate_hz, slip=-0.1) for rate_hz in RATES_HZ),
    *(Honest(rate_hz, grid_m=0.05) for rate_hz in RATES_HZ),
    Honest(30.0, burst_s=0.5),
    Honest(10.0, burst_s=0.9),
    *(Honest(rate_hz, push=Twist2D(0.1, 0.1)) for rate_hz in RATES_HZ),
    *(Honest(rate_hz, push=Twist2D(-0.1, -0.2)) for rate_hz in RATES_HZ),
]


@pytest.mark.parametrize("speeds", [(0.3, 60.0), (1.2, 300.0)])
@pytest.mark.parametrize("robot", HONEST, ids=str)
def test_no_robot_that_tells_the_truth_jumps(robot: Honest, speeds: tuple[float, float]) -> None:
    require_no_jump(robot, speeds, Random(1))


def require_no_jump(robot: Honest, speeds: tuple[float, float], draw: Random) -> None:
    commands = drives(draw, speeds[0], math.radians(speeds[1]))
    checked, number = OdometryFilter(), 0
    for arrived_s, pose in reports_of(robot, commands, draw):
        while number < len(commands) and commands[number][0] <= arrived_s:
            checked.command(commands[number][1], commands[number][0])
            number += 1
        assert not is_jump(checked, pose, arrived_s), arrived_s
    assert checked.n_valid > _LONG_S
