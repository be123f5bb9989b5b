"""The real floor: robots that answer late, stick and slip are driven to their goals, and never to and fro for ever."""

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.control import Breakaway
from pinel_desktop.control.goal import MOVE_GOAL
from pinel_desktop.links.real import delay_s, real_link
from pinel_desktop.robot import STANDSTILL, SimulationConfig
from tests.links.late_robot import Trouble, drive
from tests.links.test_real import FAST
from tests.links.unicycle import MemoryTransport, Unicycle

pytestmark = pytest.mark.waits

SQUARE = json.loads((Path(__file__).parents[1] / "programs" / "square.json").read_text("utf-8"))
LINE = [{"action": "move_forward", "distance": 0.5}]
CURVE = [{"action": "arc", "radius": 0.5, "angle": angle} for angle in (90, -90)]


def overshoot_m(trouble: Trouble, monkeypatch: pytest.MonkeyPatch) -> float:
    """How far the robot drives beyond the end of a move, at most of four."""
    farthest = []
    for seed in range(4):
        ended, robot = drive(LINE, replace(trouble, seed=seed), monkeypatch)
        assert ended.state == "finished", ended
        assert robot.x_m == pytest.approx(0.5, abs=0.012)
        farthest.append(robot.farthest_m - 0.5)
    return max(farthest)


@pytest.mark.parametrize("latency_s", [0.0, 0.05, 0.1])
@pytest.mark.parametrize("rate_hz", [10, 20, 50])
def test_the_measured_delay_lets_a_late_robot_drive_less_beyond_its_goal(
    rate_hz: int, latency_s: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    trouble = Trouble(1 / rate_hz, latency_s, lag_s=0.06)
    before_m = overshoot_m(replace(trouble, known_delay_s=0.05), monkeypatch)
    now_m = overshoot_m(trouble, monkeypatch)
    print(f"{rate_hz} Hz, {latency_s} s: {before_m * 1e3:.0f} mm, now {now_m * 1e3:.0f} mm beyond")
    assert now_m < before_m - 0.01


@pytest.mark.parametrize("rate_hz", [3, 5, 10, 30])
@pytest.mark.parametrize("sticks_mps", [0.0, 0.03])
def test_the_square_closes_on_a_robot_that_sticks_and_slips(
    rate_hz: int, sticks_mps: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    trouble = Trouble(1 / rate_hz, 0.05, 0.06, sticks_mps, slip=0.03)
    for seed in range(2):
        ended, robot = drive(SQUARE, replace(trouble, seed=seed), monkeypatch)
        assert ended.state == "finished", ended
        assert ended.duration_s < 60.0
        assert math.hypot(robot.x_m, robot.y_m) < 0.03


@pytest.mark.parametrize("rate_hz", [5, 10, 30, 50])
def test_curves_are_driven_by_a_robot_that_answers_late(
    rate_hz: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    for seed in range(4):
        ended, _ = drive(CURVE, Trouble(1 / rate_hz, 0.05, 0.06, slip=0.03, seed=seed), monkeypatch)
        assert ended.state == "finished", ended
        assert ended.duration_s < 15.0


@pytest.mark.parametrize("document", [SQUARE, CURVE])
@pytest.mark.parametrize("rate_hz", [3, 30])
def test_wheels_that_stick_badly_do_not_drive_to_and_fro_for_ever(
    document: Any, rate_hz: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    for seed in range(3):
        trouble = Trouble(1 / rate_hz, 0.1, 0.06, sticks_mps=0.06, slip=0.03, seed=seed)
        ended, _ = drive(document, trouble, monkeypatch)
        assert ended.reason in {None, "blocked", "blocked_beside"}
        assert ended.duration_s < 120.0


def test_a_robot_that_stands_beside_its_goal_gets_more_until_it_moves() -> None:
    stuck = Breakaway(MOVE_GOAL, 0.1, 1 / 30)
    added = [stuck.more(-0.02, STANDSTILL, ticks) for ticks in range(1, 60)]
    assert added[0] == pytest.approx(-0.1 / 30)
    assert min(added) == added[-1] == pytest.approx(-0.1)
    moving = STANDSTILL._replace(v_mps=-0.05)
    assert stuck.more(-0.02, moving, 60) == 0.0
    assert not stuck.is_reached(0.012, STANDSTILL, 100)
    assert stuck.more(0.012, STANDSTILL, 61) > 0.0
    assert stuck.is_reached(0.012, STANDSTILL, 101), "it went past its goal, and stands near enough"


@pytest.mark.parametrize(
    ("period_s", "delay"), [(None, 0.1), (0.01, 0.09), (0.1, 0.18), (1.0, 0.3)]
)
def test_the_delay_follows_from_how_often_the_robot_reports(
    period_s: float | None, delay: float
) -> None:
    assert delay_s(period_s) == pytest.approx(delay)


def test_the_delay_is_measured_when_the_link_connects() -> None:
    link = real_link(lambda record: MemoryTransport(Unicycle(), 0.15), SimulationConfig(), FAST)
    assert link.command_delay_s == 0.1
    link.connect()
    link.close()
    # a busy PC hands reports on late, never early
    assert 0.22 < link.command_delay_s <= 0.3
