"""Where motions end, and how fast they are."""

import math
from typing import Any

import pytest

from pinel_desktop.events.model import BlockStarted, Event, Telemetry
from pinel_desktop.execution.control import RunControl
from pinel_desktop.robot import PIONEER_3DX, Pose2D


def forward(distance: float, **more: Any) -> dict[str, Any]:
    return {"action": "move_forward", "distance": distance, **more}


def turn(angle: float) -> dict[str, Any]:
    return {"action": "turn", "angle": angle}


def arc(radius: float, angle: float) -> dict[str, Any]:
    return {"action": "arc", "radius": radius, "angle": angle}


def drive(linear: float, angular: float = 0) -> dict[str, Any]:
    return {"action": "drive", "linear": linear, "angular": angular}


def wait(seconds: float) -> dict[str, Any]:
    return {"action": "wait", "seconds": seconds}


def go_to(x: float, y: float, **more: Any) -> dict[str, Any]:
    return {"action": "go_to", "x": x, "y": y, **more}


def pose(result: Any) -> tuple[float, float, float]:
    ended = result.ended
    assert ended.state == "finished", (ended.reason, ended.params)
    return ended.pose["x_m"], ended.pose["y_m"], math.degrees(ended.pose["yaw_rad"])


def telemetry(log: Any) -> list[Telemetry]:
    return [event for _, event in log if isinstance(event, Telemetry)]


@pytest.mark.parametrize(
    ("radius", "angle", "end"),
    [
        (1, 90, (1, 1, 90)),
        (1, -90, (1, -1, -90)),
        (-1, 90, (-1, -1, 90)),
        (-1, -90, (-1, 1, -90)),
        (0.5, 360, (0, 0, 0)),
        (0.5, -540, (0, -1, 180)),
        (0, 90, (0, 0, 90)),
        (0.01, 180, (0, 0.02, 180)),
        (100, 1, (100 * math.sin(math.radians(1)), 100 * (1 - math.cos(math.radians(1))), 1)),
    ],
)
def test_arc_ends_where_geometry_says(
    radius: float, angle: float, end: tuple[float, float, float], execute_commands: Any
) -> None:
    result, _ = execute_commands(arc(radius, angle))
    x, y, heading = pose(result)
    assert (x, y) == pytest.approx(end[:2], abs=1e-3)
    assert math.remainder(heading - end[2], 360) == pytest.approx(0, abs=0.02)


def test_arc_stays_on_its_circle_and_within_both_speeds(execute_commands: Any) -> None:
    for radius in (0.2, 1.5):
        _, log = execute_commands(arc(radius, 180))
        for event in telemetry(log):
            assert math.hypot(event.x_m, event.y_m - radius) == pytest.approx(radius, abs=2e-3)
            assert abs(event.command_v_mps) <= 0.6 * 1.05
            assert abs(event.command_omega_radps) <= math.radians(90) * 1.05


def test_motions_after_an_arc_start_at_its_goal_so_that_errors_do_not_add_up(
    execute_commands: Any,
) -> None:
    clover = [arc(0.4, 90), arc(-0.4, 90), forward(0.3), turn(-135), arc(0.3, -45)]
    result, _ = execute_commands({"action": "repeat", "times": 4, "commands": clover})
    here = Pose2D()
    for _ in range(4):
        for radius, angle in ((0.4, 90), (-0.4, 90)):
            a = math.radians(angle)
            here = here.compose(Pose2D(radius * math.sin(a), radius * (1 - math.cos(a)), a))
        here = here.compose(Pose2D(0.3)).compose(Pose2D(yaw_rad=math.radians(-135)))
        a = math.radians(-45)
        here = here.compose(Pose2D(0.3 * math.sin(-a), -0.3 * (1 - math.cos(a)), a))
    x, y, _ = pose(result)
    assert (x, y) == pytest.approx((here.x_m, here.y_m), abs=1e-3)


def test_arc_that_the_wall_keeps_from_its_end_is_blocked(execute_commands: Any) -> None:
    result, _ = execute_commands({**arc(3, 180), "block": "a"})
    ended = result.ended
    assert (ended.reason, ended.block) == ("blocked_beside", "a")
    assert ended.params["unit"] == "°"


def test_arc_that_is_stopped_on_its_way_tells_its_angle(execute_commands: Any) -> None:
    start = {"x_m": 0, "y_m": 0, "heading_deg": 0}
    corner = [{"from": [1, -3], "to": [1, 3]}, {"from": [-3, 1.5], "to": [3, 1.5]}]
    world = {"name": "w", "start": start, "walls": corner}
    result, _ = execute_commands(arc(5, 90), world=world)
    assert (result.ended.state, result.ended.reason) == ("failed", "blocked")
    assert result.ended.params["done"] < 80.0


def test_arc_that_slid_along_a_wall_tells_how_far_it_is_from_its_end(execute_commands: Any) -> None:
    walls = [{"from": [-3, 2.9], "to": [3, 2.9]}]
    start = {"x_m": 0, "y_m": 0, "heading_deg": 0}
    world = {"name": "w", "start": start, "walls": walls}
    result, _ = execute_commands(arc(2, 180), world=world)
    assert (result.ended.state, result.ended.reason) == ("failed", "blocked_beside")
    params = result.ended.params
    assert params["done"] == pytest.approx(180, abs=5)
    assert params["away"] == pytest.approx(4.0 - (2.9 - 0.01 - 0.2225), abs=0.1)


def test_sliding_along_a_wall_is_blocked_where_the_robot_came_nearest(
    execute_commands: Any,
) -> None:
    slide = [turn(45), forward(3.8, block="slide"), forward(0.1)]
    result, log = execute_commands(*slide, world="tic_tac_toe")
    ended = result.ended
    assert (ended.state, ended.reason, ended.block) == ("failed", "blocked", "slide")
    last = telemetry(log)[-1]
    away = math.hypot(
        last.x_m - 3.8 * math.cos(math.pi / 4), last.y_m - 3.8 * math.sin(math.pi / 4)
    )
    assert ended.params["amount"] == 3.8
    assert 3.8 - away <= ended.params["done"] <= 3.8 - away + 0.5
    assert last.done == pytest.approx(
        ended.params["done"], abs=0.01
    )  # as the page and activities show it


@pytest.mark.parametrize("action", ["move_forward", "move_backward", "go_to"])
def test_motion_that_ends_beside_its_goal_is_blocked(action: str, execute_commands: Any) -> None:
    """A corner pushes the robot aside shortly before its goal."""
    direction = -1 if action == "move_backward" else 1
    corner = {"center": [direction * 2.2, 0.1], "size": [0.4, 0.4], "heading_deg": 45}
    start = {"x_m": 0, "y_m": 0, "heading_deg": 0}
    world = {"name": "w", "start": start, "walls": [], "boxes": [corner]}
    goal = {"x": 2.1, "y": 0} if action == "go_to" else {"distance": 2.1}
    result, log = execute_commands({"action": action, **goal, "block": "m"}, world=world)
    ended, last = result.ended, telemetry(log)[-1]
    assert (ended.state, ended.reason, ended.block) == ("failed", "blocked", "m")
    assert abs(last.y_m) > 0.1
    assert 0 < direction * ended.params["done"] < 2.1


def test_grazing_a_corner_does_not_end_a_motion(execute_commands: Any) -> None:
    """The robot is pushed aside by less than its radius, goes back to its line and arrives."""
    box = {"center": [1.5, 0.38], "size": [0.4, 0.4], "heading_deg": 45}
    start = {"x_m": 0, "y_m": 0, "heading_deg": 0}
    world = {"name": "w", "start": start, "walls": [], "boxes": [box]}
    result, log = execute_commands(forward(3), world=world)
    assert min(event.y_m for event in telemetry(log)) < -0.1
    assert pose(result)[:2] == pytest.approx((3, 0), abs=0.05)


def test_done_of_an_arc_counts_up_to_its_angle(execute_commands: Any) -> None:
    _, log = execute_commands(arc(0.5, -120))
    assert [e.amount for _, e in log if isinstance(e, BlockStarted)] == [-120]
    assert min(event.done for event in telemetry(log)) == pytest.approx(-120, abs=0.5)


def test_pause_in_the_middle_of_an_arc_ends_at_the_same_goal(execute_commands: Any) -> None:
    control = RunControl()

    class Resuming:
        waits = 0

        def wait_for_tick(self) -> None:
            self.waits += control.pause_requested
            if self.waits == 10:
                control.resume()

    def pause(tick: int, event: Event) -> None:
        if tick == 40 and isinstance(event, Telemetry):
            control.pause()

    result, _ = execute_commands(arc(1, 90), control=control, clock=Resuming(), listener=pause)
    assert pose(result)[:2] == pytest.approx((1, 1), abs=2e-3)


def test_drive_lasts_until_the_next_motion_command(execute_commands: Any) -> None:
    result, log = execute_commands(drive(0.3), wait(2), {"action": "stop"}, wait(1))
    assert pose(result)[0] == pytest.approx(0.6, abs=0.02)
    assert telemetry(log)[-1].v_mps == 0


def test_drive_is_ended_by_the_end_of_the_program(execute_commands: Any) -> None:
    result, log = execute_commands(drive(0.3, 45), wait(1))
    assert result.ended.state == "finished"
    assert (telemetry(log)[-1].command_v_mps, telemetry(log)[-1].command_omega_radps) == (0, 0)
    assert abs(telemetry(log)[-1].v_mps) < 1e-3
    assert pose(result)[2] == pytest.approx(45, abs=1.5)


def test_motion_after_drive_starts_at_the_measured_pose(execute_commands: Any) -> None:
    straight, _ = execute_commands(drive(0.3), wait(1), forward(1))
    assert pose(straight)[0] == pytest.approx(1.3, abs=0.02)
    curved, _ = execute_commands(drive(0.3, 90), wait(1), {"action": "stop"}, forward(0.5))
    stopped, _ = execute_commands(drive(0.3, 90), wait(1), {"action": "stop"})
    x, y, heading = pose(stopped)
    along = math.radians(heading)
    assert pose(curved)[:2] == pytest.approx(
        (x + 0.5 * math.cos(along), y + 0.5 * math.sin(along)), abs=2e-3
    )


def test_drive_is_never_blocked(execute_commands: Any) -> None:
    result, log = execute_commands(drive(0.5), wait(12), forward(0))
    assert result.ended.state == "finished"
    assert any(event.bumper for event in telemetry(log))


def test_drive_goes_on_after_a_pause(execute_commands: Any) -> None:
    control = RunControl()

    class Resuming:
        waits = 0

        def wait_for_tick(self) -> None:
            self.waits += control.pause_requested
            if self.waits == 30:
                control.resume()

    def pause(tick: int, event: Event) -> None:
        if tick == 30 and isinstance(event, Telemetry):
            control.pause()

    result, _ = execute_commands(
        drive(0.3), wait(2), control=control, clock=Resuming(), listener=pause
    )
    assert pose(result)[0] == pytest.approx(0.6, abs=0.02)


def test_drive_keeps_to_the_limits_that_are_set(execute_commands: Any) -> None:
    _, log = execute_commands(drive(5, -1000), wait(0.5))
    command = telemetry(log)[3]
    assert command.command_v_mps == 0.6
    assert command.command_omega_radps == pytest.approx(-math.radians(90))


def test_setpoint_follows_the_robot_while_it_drives(execute_commands: Any) -> None:
    _, log = execute_commands(drive(0.3), wait(1))
    event = telemetry(log)[20]
    assert event.goal_x_m == event.x_m > 0


def test_set_speed_holds_for_the_motions_that_follow(execute_commands: Any) -> None:
    slow = {"action": "set_speed", "linear": 0.2, "angular": 30}
    _, log = execute_commands(forward(0.5), slow, forward(0.5), turn(90))
    v = [event.command_v_mps for event in telemetry(log)]
    omega = [event.command_omega_radps for event in telemetry(log)]
    assert max(v) == pytest.approx(0.6, abs=0.05)
    assert max(v[len(v) // 2 :]) == pytest.approx(0.2, rel=0.01)
    assert max(omega) == pytest.approx(math.radians(30), rel=0.01)


def test_set_speed_of_one_leaves_the_other(execute_commands: Any) -> None:
    fast = {"action": "set_speed", "linear": PIONEER_3DX.max_v_mps}
    result, log = execute_commands(fast, forward(3), turn(90))
    assert pose(result) == pytest.approx((3, 0, 90), abs=1e-2)
    assert max(event.command_v_mps for event in telemetry(log)) == pytest.approx(1.2, rel=0.01)
    omega = max(event.command_omega_radps for event in telemetry(log))
    assert omega == pytest.approx(math.radians(90), rel=0.01)


@pytest.mark.parametrize(
    ("command", "reason", "params"),
    [
        ({"linear": 1.3}, "speed_out_of_range", {"value": 1.3, "max": 1.2, "unit": "m/s"}),
        ({"angular": 301}, "speed_out_of_range", {"value": 301, "max": 300, "unit": "°/s"}),
        ({"linear": {"op": "-", "args": [1, 1]}}, "linear_not_positive", {"value": 0, "min": 0, "max": None}),
        ({"angular": {"op": "-", "args": [0, 1]}}, "angular_not_positive", {"value": -1, "min": 0, "max": None}),
    ],
)  # fmt: skip
def test_speeds_the_robot_cannot_do_fail_the_run_at_the_block(
    command: Any, reason: str, params: Any, execute_commands: Any
) -> None:
    result, _ = execute_commands({"action": "set_speed", "block": "s", **command})
    ended = result.ended
    assert (ended.state, ended.reason, ended.params, ended.block) == ("failed", reason, params, "s")


def test_fastest_speeds_of_the_record_are_allowed(execute_commands: Any) -> None:
    result, _ = execute_commands({"action": "set_speed", "linear": 1.2, "angular": 300}, turn(720))
    assert result.ended.duration_s < 4


@pytest.mark.parametrize("goal", [(1, 0), (1, 1), (-1, 0), (-0.5, -2), (0, 0), (0.001, 0)])
def test_go_to_ends_at_the_point_and_looks_away_from_where_it_came(
    goal: tuple[float, float], execute_commands: Any
) -> None:
    result, _ = execute_commands(go_to(*goal))
    x, y, heading = pose(result)
    assert (x, y) == pytest.approx(goal, abs=1e-4)
    towards = math.degrees(math.atan2(goal[1], goal[0]))
    assert math.remainder(heading - towards, 360) == pytest.approx(0, abs=0.02)


def test_go_to_is_in_the_start_frame_and_turns_the_smaller_way(execute_commands: Any) -> None:
    result, log = execute_commands(turn(170), go_to(-0.5, -0.2), go_to(0.5, 0), world="tic_tac_toe")
    assert pose(result)[:2] == pytest.approx((0.5, 0), abs=1e-4)
    assert max(abs(event.done) for event in telemetry(log)) < 181


@pytest.mark.parametrize(
    ("command", "reason", "params"),
    [
        (forward(-1), "distance_out_of_range", {"value": -1, "min": 0, "max": 100}),
        (forward(100.5), "distance_out_of_range", {"value": 100.5, "min": 0, "max": 100}),
        (turn(3601), "angle_out_of_range", {"value": 3601, "min": -3600, "max": 3600}),
        (arc(101, 1), "radius_out_of_range", {"value": 101, "min": -100, "max": 100}),
        (go_to(0, -101), "y_out_of_range", {"value": -101, "min": -100, "max": 100}),
        (go_to(101, 0), "x_out_of_range", {"value": 101, "min": -100, "max": 100}),
        (wait(-0.1), "seconds_out_of_range", {"value": -0.1, "min": 0, "max": 600}),
    ],
)
def test_values_out_of_range_that_only_the_run_knows_fail_as_they_would_on_reading(
    command: dict[str, Any], reason: str, params: Any, execute_commands: Any
) -> None:
    names = [name for name in command if name != "action"]
    setting = [{"action": "set_variable", "name": name, "value": command[name]} for name in names]
    computed = {name: {"var": name} for name in names}
    result, _ = execute_commands(*setting, {**command, **computed, "block": "b"})
    ended = result.ended
    assert (ended.reason, ended.params, ended.block) == (reason, params, "b")


def test_text_where_a_number_belongs_fails_the_run(execute_commands: Any) -> None:
    result, log = execute_commands(
        {"action": "set_variable", "name": "far", "value": "far"},
        {"action": "move_forward", "distance": {"var": "far"}, "block": "m"},
    )
    assert (result.ended.reason, result.ended.params) == ("wrong_type_number", {"name": "distance"})
    assert [e.block for _, e in log if isinstance(e, BlockStarted)] == [None, "m"]


def test_amount_is_known_when_the_value_was_computed(execute_commands: Any) -> None:
    _, log = execute_commands(
        {"action": "move_backward", "distance": {"op": "/", "args": [1, 4]}},
    )
    assert [e.amount for _, e in log if isinstance(e, BlockStarted)] == [-0.25]
    assert telemetry(log)[0].command_v_mps <= 0
