"""What those who watch a run are told of pushed boxes, of true poses and of what sensors measure."""

import itertools
import math
from typing import Any

import pytest

from pinel_desktop.events.model import BoxesMoved, Event, Ranges, RunEnded, RunState, Telemetry
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.executor import RunOptions, RunResult, execute
from pinel_desktop.links import open_link
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import SMALL_ROBOT, SimulationConfig
from tests.sim.rooms import box, room_document

Log = list[tuple[int, Event]]
PUSH = [{"action": "move_forward", "distance": 1.2}]
START = (-1.0, 0.5, 90.0)


def watched(
    commands: list[dict[str, Any]],
    *boxes: dict[str, Any],
    setting: SimulationConfig | None = None,
    control: RunControl | None = None,
    start: tuple[float, float, float] = (0.0, 0.0, 0.0),
) -> tuple[RunResult, Log]:
    setting, log = setting or SimulationConfig(), list[tuple[int, Event]]()
    program = read_document({"pinel_ir": 1, "commands": commands}).program
    assert program is not None
    link = open_link("sim", world=room_document(*boxes, start=start), setting=setting, seed=5)
    options = RunOptions(
        observer=lambda tick, event: log.append((tick, event)),
        control=control or RunControl(),
        robot=setting.robot,
        seed=5,
    )
    return execute(program, link, options), log


def of_type(log: Log, kind: type[Event]) -> list[tuple[int, Any]]:
    return [(tick, event) for tick, event in log if isinstance(event, kind)]


def test_pushed_boxes_are_told_at_most_ten_times_a_second_and_where_they_end() -> None:
    result, log = watched(
        PUSH, box(0.8, 0.0, movable=True), box(0.0, 1.5, movable=True), box(1.6, -1.5)
    )
    reports = of_type(log, BoxesMoved)
    assert result.ended.state == "finished"
    assert {name for _, event in reports for name in event.boxes} == {"0"}
    ticks = [tick for tick, _ in reports]
    assert len(ticks) > 5
    assert min(b - a for a, b in itertools.pairwise(ticks[:-1])) >= 3
    x, y, yaw = reports[-1][1].boxes["0"]
    assert x == pytest.approx(1.2 + 0.2225 + 0.2, abs=0.02)
    assert (y, yaw) == pytest.approx((0, 0), abs=0.02)
    assert isinstance(log[-1][1], RunEnded)


def test_boxes_are_told_in_the_frame_of_the_world() -> None:
    _, log = watched(PUSH, box(-1.0, 1.2, movable=True), start=START)
    x, y, _ = of_type(log, BoxesMoved)[-1][1].boxes["0"]
    assert x == pytest.approx(-1.0, abs=0.02)
    assert y > 1.6


def test_nothing_is_told_of_boxes_that_nobody_pushes() -> None:
    _, log = watched([{"action": "turn", "angle": 90}], box(0.8, 0.0, movable=True))
    assert of_type(log, BoxesMoved) == []


def test_ranges_are_told_at_most_ten_times_a_second_while_somebody_asks() -> None:
    control = RunControl()
    control.subscriptions = frozenset(["lidar"])
    result, log = watched(PUSH, control=control)
    reports = of_type(log, Ranges)
    assert len(reports) == pytest.approx(result.ended.duration_s * 10, abs=2)
    ranges = reports[0][1]
    assert ranges.sonar is None
    assert len(ranges.lidar) == 181
    assert ranges.lidar[0] == ranges.lidar[180] == pytest.approx(1.99, abs=1e-3)
    assert ranges.lidar[45] == pytest.approx(1.99 * math.sqrt(2), abs=0.05)
    assert of_type(watched(PUSH)[1], Ranges) == []


def test_looking_does_not_change_the_run() -> None:
    control = RunControl()
    control.subscriptions = frozenset(["lidar", "sonar"])
    setting = SimulationConfig(preset="realistic")
    subscribed, _ = watched(PUSH, setting=setting, control=control)
    unseen, _ = watched(PUSH, setting=setting)
    assert subscribed.ended.telemetry_sha256 == unseen.ended.telemetry_sha256


def test_robot_without_a_scanner_tells_none_and_its_three_sonars() -> None:
    control = RunControl()
    control.subscriptions = frozenset(["lidar", "sonar"])
    setting = SimulationConfig(model=SMALL_ROBOT.name)
    _, log = watched(PUSH, control=control, setting=setting)
    ranges = of_type(log, Ranges)[0][1]
    assert ranges.lidar is None
    assert ranges.sonar[1] == pytest.approx(1.99 - SMALL_ROBOT.radius_m, abs=0.01)
    assert len(ranges.sonar) == 3


def test_who_looks_during_a_pause_is_told_once() -> None:
    control, log = RunControl(), list[tuple[int, Event]]()
    program = read_document({"pinel_ir": 1, "commands": PUSH}).program
    assert program is not None

    class Waiting:
        """A clock whose ticks in the pause stand for somebody who presses a button now and then."""

        def __init__(self) -> None:
            self.n_ticks = 0

        def wait_for_tick(self) -> None:
            self.n_ticks += 1
            if self.n_ticks == 10:
                control.pause()
            if self.n_ticks == 60:
                control.subscriptions = frozenset(["sonar"])
            if self.n_ticks == 80:
                control.subscriptions = frozenset()
            if self.n_ticks == 100:
                control.resume()

    execute(
        program,
        open_link("sim", world="empty_room"),
        RunOptions(
            observer=lambda tick, event: log.append((tick, event)),
            control=control,
            clock=Waiting(),
        ),
    )
    kinds = [event for _, event in log if isinstance(event, Ranges | RunState)]
    reports = [event for event in kinds if isinstance(event, Ranges)]
    assert [event.sonar is None for event in reports] == [False, True]
    assert isinstance(kinds[-1], RunState)  # between the pause and going on


def test_true_pose_is_the_pose_of_an_ideal_robot_in_the_start_frame() -> None:
    _, log = watched(PUSH, start=START)
    for _, event in of_type(log, Telemetry):
        assert (event.true_x_m, event.true_y_m, event.true_yaw_rad) == (
            event.x_m,
            event.y_m,
            event.yaw_rad,
        )
    assert event.true_x_m == pytest.approx(1.2, abs=1e-3)


def test_true_pose_of_a_robot_that_knows_its_wheels_only_is_another() -> None:
    _, log = watched(PUSH, setting=SimulationConfig(preset="realistic", feedback="odometry"))
    last = of_type(log, Telemetry)[-1][1]
    assert last.x_m == pytest.approx(1.2, abs=0.005)
    assert 1e-4 < math.hypot(last.true_x_m - last.x_m, last.true_y_m - last.y_m) < 0.2


@pytest.mark.parametrize(
    ("expression", "sensor"),
    [
        ({"sensor": "lidar", "angle": 0}, "lidar"),
        ({"sensor": "sonar", "index": 3}, "sonar"),
        ({"sensor": "distance", "direction": "back"}, "distance"),
    ],
)
def test_sensor_that_the_small_robot_lacks_fails_the_run_in_words(
    expression: dict[str, Any], sensor: str
) -> None:
    command = {"action": "set_variable", "name": "x", "value": expression}
    result, _ = watched([command], setting=SimulationConfig(model=SMALL_ROBOT.name))
    assert (result.ended.reason, result.ended.params) == ("sensor_missing", {"sensor": sensor})
