"""Poses as a program over HTTP posts them: begun anew, jumped, impossible, late; the robot is stopped or not misled."""

import json
import math
import time
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.messages import LANGUAGES, describe
from pinel_desktop.robot import STANDSTILL
from pinel_desktop.robot.robot_profile import BridgeProfile, Room
from pinel_desktop.runs.robots.jog import Jog
from pinel_desktop.runs.robots.monitor import RobotMonitor
from pinel_desktop.runs.spec import RunSpec
from tests.links.aurora import Aurora, free_port
from tests.links.real_link_contract import LiveRun

pytestmark = pytest.mark.waits

PROGRAMS = Path(__file__).parents[1] / "programs"
SQUARE = json.loads((PROGRAMS / "square.json").read_text("utf-8"))
FAR = [{"action": "move_forward", "distance": 3.0}]
FAR_AFTER_A_TURN = [{"action": "turn", "angle": 90}, *FAR]
WAIT_S = 60.0


class Trial:
    """A run over HTTP, whose robot does what the test says."""

    def __init__(self, document: list[Any], *options: str) -> None:
        room = Room(width_m=20.0, depth_m=20.0)
        record = BridgeProfile(port=free_port(), room=room)
        self.robot = Aurora(record.port, *options)
        spec = RunSpec(document, "empty_room", link="bridge", robot=record)
        self.run = LiveRun(spec)
        self.run.thread.start()

    def until_driven(self, metres: float) -> None:
        """Waits until the robot is so far from its start."""
        self._until(lambda: bool(self.robot.positions) and self.robot_is_at() >= metres)

    def robot_is_at(self) -> float:
        """The robot's true distance from its start."""
        return math.hypot(*self.robot.positions[-1])

    def until_standstill(self) -> None:
        self._until(lambda: self.robot.received[-1][1] == STANDSTILL)

    def _until(self, condition: Callable[[], bool]) -> None:
        due_s = time.monotonic() + WAIT_S
        while not condition():
            assert time.monotonic() < due_s, self.run.thread.is_alive() or self.run.result().ended
            time.sleep(0.01)


@pytest.fixture
def try_out() -> Iterator[Callable[..., Trial]]:
    trials: list[Trial] = []

    def begin(document: list[Any], *options: str) -> Trial:
        trials.append(Trial(document, *options))
        return trials[-1]

    yield begin
    for trial in trials:
        trial.run.control.stop()
        trial.run.result()
        trial.robot.close()


@pytest.mark.parametrize(("document", "after_m"), [(FAR, 0.35), (FAR_AFTER_A_TURN, 1.0)])
@pytest.mark.parametrize("away_s", [0.45])
def test_a_robot_side_that_begins_anew_ends_the_run_at_once(
    document: list[Any], after_m: float, away_s: float, try_out: Callable[..., Trial]
) -> None:
    trial = try_out(document)
    trial.until_driven(after_m)
    trial.robot.order(f"restart {away_s}")
    ended = trial.run.result().ended
    assert (ended.state, ended.reason) == ("failed", "reference_lost")
    trial.until_standstill()
    assert trial.robot_is_at() < after_m + 0.3
    for language in LANGUAGES:
        text = describe("reference_lost", ended.params, language)
        assert "{" not in text.line


@pytest.mark.parametrize("jump", ["jump 1", "jump -1", "turn 1.57"])
@pytest.mark.parametrize("rate_hz", [2, 30])
def test_a_jump_ends_the_run_whatever_the_rate(
    jump: str, rate_hz: int, try_out: Callable[..., Trial]
) -> None:
    trial = try_out(FAR, "--rate", str(rate_hz))
    trial.until_driven(0.4)
    trial.robot.order(jump)
    ended = trial.run.result().ended
    assert (ended.state, ended.reason) == ("failed", "reference_lost")
    trial.until_standstill()
    assert trial.robot_is_at() < 1.2


def test_impossible_poses_for_a_second_are_called_so(try_out: Callable[..., Trial]) -> None:
    trial = try_out(FAR)
    trial.until_driven(0.2)
    trial.robot.order("nonsense")
    ended = trial.run.result().ended
    assert (ended.state, ended.reason) == ("failed", "odometry_invalid")
    trial.until_standstill()


def test_keys_stop_where_the_robot_jumps_and_its_place_is_counted_anew() -> None:
    record = BridgeProfile(port=free_port(), room=Room(width_m=20.0, depth_m=20.0))
    states: list[dict[str, Any]] = []
    watched = RobotMonitor(record, states.append)
    jog, aurora = Jog(watched), Aurora(record.port)

    def hold_until(condition: Callable[[], bool], drive: float = 1.0) -> None:
        due_s = time.monotonic() + WAIT_S
        while not condition():
            assert time.monotonic() < due_s, states[-1]
            watched.renew_lease(record)
            jog.command(record, drive, 0.0, time.time())
            time.sleep(0.1)

    with closing(aurora), closing(watched):
        hold_until(lambda: watched.start is not None, drive=0.0)
        hold_until(lambda: aurora.positions[-1][0] > 0.2)
        aurora.order("jump -1")
        hold_until(lambda: any(state["code"] == "reference_lost" for state in states))
        jog.end()
        assert watched.start is None
        assert aurora.has_ended(WAIT_S)  # a client takes the end of a drive for that of a run
    time.sleep(0.6)  # the keys count again once they were let go for so long
    with closing(Aurora(record.port)) as again, closing(watched):
        hold_until(lambda: any(v > 0.0 for _, (v, _) in again.received))
        jog.end()


# Printed: 0.1 to 0.6 mm, the more the slower the client is. The controller itself only asks for 10 mm.
CLOSES_WITHIN_M = 0.001
LATE = "--jitter 0.1 --lost 0.02"
# A client at 2.5 Hz that a busy PC delays besides turns to and fro until its turn counts as blocked.
NIGHTLY = [
    *((f"--rate {rate}", 0) for rate in (5, 10, 30, 50)),
    *((f"--rate {rate} {LATE}", 0) for rate in (5, 30, 50)),
    *((f"--rate {rate}", 3) for rate in (5, 30, 50)),
]


@pytest.mark.parametrize(
    ("options", "n_pauses"),
    [
        (f"--rate 10 {LATE}", 3),
        *(pytest.param(*each, marks=pytest.mark.nightly) for each in NIGHTLY),
    ],
)
def test_the_square_closes_with_a_client_that_is_slow_late_or_begins_anew_in_place(
    options: str, n_pauses: int, try_out: Callable[..., Trial]
) -> None:
    """One that begins anew in place does nothing for 0.5 s, and is where it was."""
    trial = try_out(SQUARE, *options.split())
    for distance_m in (0.5, 1.2, 1.35)[:n_pauses]:
        trial.until_driven(distance_m)
        trial.robot.order("pause 0.5")
    ended = trial.run.result(100.0).ended
    assert ended.state == "finished", ended
    trial.until_standstill()
    off_m = trial.robot_is_at()
    print(f"{options}, {n_pauses} pauses: {off_m * 1e3:.2f} mm off after {ended.duration_s:.1f} s")
    assert off_m < CLOSES_WITHIN_M
