"""How far from its start a robot ends: where it truly stands, and beside it where it believes to be."""

import json
import math
from collections.abc import Iterator
from typing import Any

import pytest

from pinel_desktop.activities.run_log import RunLogBuilder
from pinel_desktop.events.model import RunEnded
from pinel_desktop.links.sim import SimLink
from pinel_desktop.robot import PIONEER_3DX, Feedback, Preset, RobotState, SimulationConfig
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.runs.start import start
from sim.world import world_document
from tests.execution.test_path_length import SQUARE
from tests.test_programs import PROGRAMS

FAILS_AT_ONCE = {**SQUARE, "commands": [{"action": "say", "text": {"var": "nobody"}}]}
WORLDS = ("empty_room", "maze")  # the second one's start is not its origin


def driven(
    preset: Preset,
    feedback: Feedback,
    document: dict[str, Any] = SQUARE,
    world: str = "empty_room",
    **more: Any,
) -> tuple[RunEnded, float]:
    """How the run ended, and how far from its start the robot truly was then."""
    writer = RunLogBuilder()
    setting = SimulationConfig(PIONEER_3DX.name, preset, feedback)
    spec = RunSpec(document, world_document(world), setting=setting, seed=1, **more)
    ended = start(spec, writer.observe).ended
    x_m, y_m, _ = writer.log().poses[-1]
    return ended, math.hypot(x_m, y_m)


@pytest.mark.parametrize("world", WORLDS)
@pytest.mark.parametrize("feedback", ["pose", "odometry"])
def test_a_realistic_robot_reports_where_it_truly_is_and_its_estimate_under_its_own_name(
    feedback: Feedback, world: str
) -> None:
    ended, true_m = driven("realistic", feedback, world=world)
    assert ended.pose is not None
    assert ended.closing_error_m == pytest.approx(true_m, abs=1e-4)
    assert ended.estimated_closing_error_m == math.hypot(ended.pose["x_m"], ended.pose["y_m"])


def test_a_square_on_wheels_does_not_report_that_it_closed() -> None:
    square = json.loads((PROGRAMS / "square.json").read_bytes())
    ended, _ = driven("realistic", "odometry", square)
    assert ended.closing_error_m == pytest.approx(0.050, abs=0.001)
    assert ended.estimated_closing_error_m is not None
    assert ended.estimated_closing_error_m < 1e-4


def test_an_ideal_robot_knows_where_it_is() -> None:
    ended, _ = driven("ideal", "pose")
    assert ended.closing_error_m == ended.estimated_closing_error_m
    assert ended.closing_error_m is not None
    assert ended.closing_error_m < 1e-4


def test_a_run_that_fails_before_its_first_tick_ends_at_its_start() -> None:
    ended, _ = driven("realistic", "odometry", FAILS_AT_ONCE)
    assert (ended.state, ended.closing_error_m) == ("failed", 0.0)
    assert ended.estimated_closing_error_m == 0.0


def test_a_run_of_before_comes_out_with_its_estimate_as_it_did() -> None:
    ended, true_m = driven("realistic", "odometry", semantics=3)
    assert ended.closing_error_m is not None
    assert ended.closing_error_m < 1e-4 < true_m
    assert ended.estimated_closing_error_m is None


@pytest.fixture
def without_truth(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Robots tell what real ones do: their estimate, and nothing of where they truly are."""
    known = SimLink.read

    def read(link: SimLink) -> RobotState:
        return known(link)._replace(true_pose=None)

    with monkeypatch.context() as patch:
        patch.setattr(SimLink, "read", read)
        yield


@pytest.mark.usefixtures("without_truth")
def test_where_only_the_robots_estimate_exists_nothing_is_reported_as_the_truth() -> None:
    ended, _ = driven("realistic", "odometry")
    assert ended.closing_error_m is None
    assert ended.estimated_closing_error_m is not None
    assert ended.estimated_closing_error_m < 1e-4
