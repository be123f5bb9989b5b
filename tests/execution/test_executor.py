import itertools
import math
from itertools import pairwise
from typing import Any

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.events.model import (
    BlockEnded,
    BlockStarted,
    Event,
    RunEnded,
    RunState,
    Telemetry,
)
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.executor import RunOptions, execute
from pinel_desktop.execution.limits import StepLimit
from pinel_desktop.links import open_link
from pinel_desktop.links.sim import SimLink
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import STANDSTILL, RobotState, SimulationConfig, Twist2D

FORWARD = {"action": "move_forward", "distance": 1}
STOP = {"action": "stop"}


def of_type(log: Any, kind: type[Event]) -> list[Any]:
    return [event for _, event in log if isinstance(event, kind)]


def test_commands_run_in_their_order_whatever_they_are(execute_commands: Any) -> None:
    _, log = execute_commands(
        {"action": "set_gesture_result", "result": "A", "block": "1"},
        {**FORWARD, "block": "2"},
        {"action": "set_gesture_result", "result": "B", "block": "3"},
        {
            "action": "conditional_execution",
            "condition": "result == 'B'",
            "block": "4",
            "commands": [{"action": "turn", "angle": 90, "block": "5"}],
        },
        {"action": "wait", "seconds": 1, "block": "6"},
    )
    assert [event.block for event in of_type(log, BlockStarted)] == ["1", "2", "3", "4", "5", "6"]
    assert [event.block for event in of_type(log, BlockEnded)] == ["1", "2", "3", "5", "4", "6"]


def test_every_started_block_ends_and_ticks_never_go_back(execute_commands: Any) -> None:
    _, log = execute_commands(
        {"action": "repeat", "times": 3, "commands": [FORWARD, {"action": "turn", "angle": 90}]}
    )
    opened: list[str] = []
    for _, event in log:
        if isinstance(event, BlockStarted):
            opened.append(event.pointer)
        elif isinstance(event, BlockEnded):
            assert opened.pop() == event.pointer
    assert opened == []
    ticks = [tick for tick, _ in log]
    assert ticks == sorted(ticks)
    assert [tick for tick, event in log if isinstance(event, Telemetry)] == list(
        range(1, ticks[-1] + 1)
    )


def test_pointers_lead_to_the_running_commands(execute_commands: Any) -> None:
    _, log = execute_commands(
        {
            "action": "repeat",
            "times": 1,
            "commands": [
                {
                    "action": "conditional_execution",
                    "condition": "1 == 2",
                    "commands": [],
                    "else": [STOP],
                }
            ],
        }
    )
    assert [event.pointer for event in of_type(log, BlockStarted)] == [
        "/commands/0",
        "/commands/0/commands/0",
        "/commands/0/commands/0/else/0",
    ]


def test_n_executed_counts_commands_but_no_loops_and_conditionals(execute_commands: Any) -> None:
    result, _ = execute_commands(
        {
            "action": "repeat",
            "times": 5,
            "commands": [
                {"action": "conditional_execution", "condition": "1 == 1", "commands": [STOP, STOP]}
            ],
        }
    )
    assert result.ended.n_executed == 10


def test_loop_without_motion_lets_time_pass_and_is_reported_five_times_a_second(
    execute_commands: Any,
) -> None:
    result, log = execute_commands(
        {
            "action": "repeat",
            "times": 100_000,
            "commands": [{"action": "set_gesture_result", "result": "A", "block": "s"}],
        }
    )
    assert result.ended.state == "finished"
    assert result.ended.n_executed == 100_000
    assert result.ended.duration_s == pytest.approx(200_000 / 1000 / 30, rel=0.02)
    started = [
        tick for tick, event in log if isinstance(event, BlockStarted) and event.block == "s"
    ]
    assert all(following - earlier >= 5 for earlier, following in pairwise(started))


def test_empty_program_finishes_at_once(execute_commands: Any) -> None:
    result, log = execute_commands()
    assert (result.ended.state, result.ended.duration_s, result.ended.n_executed) == (
        "finished",
        0.0,
        0,
    )
    assert [type(event) for _, event in log] == [RunState, RunEnded]


def test_stop_ends_the_run_at_rest_within_a_few_ticks(execute_commands: Any) -> None:
    control = RunControl()
    pressed = 40

    def press(tick: int, _event: Event) -> None:
        if tick == pressed:
            control.stop()

    result, log = execute_commands({**FORWARD, "block": "f"}, control=control, listener=press)
    last = of_type(log, Telemetry)[-1]
    assert (result.ended.state, result.ended.reason, result.ended.block) == (
        "stopped",
        "stopped_by_person",
        "f",
    )
    assert result.ended.duration_s * 30 <= pressed + 3
    assert abs(last.v_mps) < 1e-3
    assert (last.command_v_mps, last.command_omega_radps) == STANDSTILL


def test_pause_stands_still_and_resume_goes_on_to_the_same_goal(execute_commands: Any) -> None:
    control = RunControl()
    paused_at: list[float] = []

    class Resuming:
        """A clock that resumes after ten waits in the pause."""

        waits = 0

        def wait_for_tick(self) -> None:
            self.waits += control.pause_requested
            if self.waits == 10:
                control.resume()

    def pause(tick: int, event: Event) -> None:
        if tick == 30 and isinstance(event, Telemetry):
            control.pause()
        if isinstance(event, Telemetry) and event.command_v_mps == 0 and tick > 30:
            paused_at.append(event.x_m)

    result, log = execute_commands(
        FORWARD, {"action": "turn", "angle": 90}, control=control, clock=Resuming(), listener=pause
    )
    assert [event.state for event in of_type(log, RunState)] == ["running", "paused", "running"]
    assert result.ended.state == "finished"
    assert result.ended.pose["x_m"] == pytest.approx(1.0, abs=1e-4)
    assert 0.2 < paused_at[0] < 0.8


def test_stop_wins_over_pause(execute_commands: Any) -> None:
    control = RunControl()

    class Stopping:
        waits = 0

        def wait_for_tick(self) -> None:
            self.waits += 1
            if self.waits == 20:
                control.pause()
            if self.waits == 40:
                control.stop()

    result, _ = execute_commands(FORWARD, control=control, clock=Stopping())
    assert result.ended.state == "stopped"


def test_motion_in_a_turn_counts_done_in_degrees_up_to_its_amount(execute_commands: Any) -> None:
    _, log = execute_commands({"action": "turn", "angle": -270})
    assert of_type(log, BlockStarted)[0].amount == -270
    done = [event.done for event in of_type(log, Telemetry)]
    assert min(done) == pytest.approx(-270, abs=0.5)
    assert all(b <= a + 1e-9 for a, b in itertools.pairwise(done[:50]))


def test_blocked_motion_fails_at_its_block_two_seconds_after_it_stood_still(
    execute_commands: Any,
) -> None:
    result, log = execute_commands({"action": "move_forward", "distance": 9, "block": "wall"})
    ended = result.ended
    assert (ended.state, ended.reason, ended.block) == ("failed", "blocked", "wall")
    assert ended.params["done"] == pytest.approx(3.767, abs=0.002)
    assert ended.params["amount"] == 9
    first_touch = next(tick for tick, event in log if isinstance(event, Telemetry) and event.bumper)
    assert ended.duration_s * 30 - first_touch == pytest.approx(60, abs=4)


def test_turn_against_a_wall_still_turns(execute_commands: Any) -> None:
    result, _ = execute_commands(
        {"action": "move_forward", "distance": 3.76}, {"action": "turn", "angle": 360}
    )
    assert result.ended.state == "finished"


class SlipperyLink(SimLink):
    """A simulated robot that somebody may push, or that falls silent."""

    def __init__(self, fail_at: int | None = None) -> None:
        super().__init__(world="empty_room", setting=SimulationConfig(), seed=0)
        self.commands: list[Twist2D] = []
        self.fail_at = fail_at
        self.closed = False

    def read(self) -> RobotState:
        if self.fail_at is not None and len(self.commands) >= self.fail_at:
            raise PinelError("link_lost")
        return super().read()

    def command(self, twist: Twist2D) -> None:
        self.commands.append(twist)
        super().command(twist)

    def close(self) -> None:
        self.closed = True
        super().close()


def run_on(link: SlipperyLink, options: RunOptions | None = None) -> RunEnded:
    program = read_document(
        {"pinel_ir": 1, "commands": [FORWARD, {"action": "turn", "angle": 90}]}
    ).program
    assert program is not None
    return execute(program, link, options).ended


def test_lost_link_fails_the_run_and_the_last_command_is_zero() -> None:
    link = SlipperyLink(fail_at=25)
    ended = run_on(link)
    assert (ended.state, ended.reason) == ("failed", "link_lost")
    assert link.commands[-2] != STANDSTILL
    assert link.commands[-1] == STANDSTILL
    assert link.closed


def test_defect_in_an_observer_fails_the_run_and_the_last_command_is_zero() -> None:
    link = SlipperyLink()

    def broken(tick: int, event: Event) -> None:
        if tick == 20 and isinstance(event, Telemetry):
            raise RuntimeError("the observer broke")

    ended = run_on(link, RunOptions(observer=broken))
    assert (ended.state, ended.reason) == ("failed", "internal_error")
    assert "the observer broke" in ended.params["detail"]
    assert link.commands[-1] == STANDSTILL


def test_finished_run_ends_with_zero_and_at_rest() -> None:
    link = SlipperyLink()
    assert run_on(link).state == "finished"
    assert link.commands[-1] == STANDSTILL
    assert math.hypot(*link.read().twist) < 1e-9


def test_run_is_ended_by_its_time_limit(execute_commands: Any) -> None:
    result, _ = execute_commands(
        {"action": "repeat", "times": 10, "commands": [{"action": "wait", "seconds": 600}]}
    )
    assert (result.ended.state, result.ended.reason) == ("failed", "time_limit")
    assert result.ended.duration_s == 3600


def test_start_frame_is_where_the_robot_stood(execute_commands: Any) -> None:
    result, log = execute_commands({"action": "turn", "angle": 90}, world="obstacles")
    first = of_type(log, Telemetry)[0]
    assert (first.x_m, first.y_m) == pytest.approx((0, 0), abs=1e-9)
    assert result.ended.pose["yaw_rad"] == pytest.approx(math.pi / 2, abs=1e-4)


def test_same_run_has_the_same_hash_whether_somebody_watches_or_not(execute_commands: Any) -> None:
    watched, _ = execute_commands(FORWARD, {"action": "turn", "angle": 135})
    program = read_document([FORWARD, {"action": "turn", "angle": 135}]).program
    assert program is not None
    alone = execute(program, open_link("sim", world="empty_room"))
    assert alone.ended.telemetry_sha256 == watched.ended.telemetry_sha256
    assert len(alone.telemetry.rows) == 8 * round(alone.ended.duration_s * 30)


@pytest.mark.parametrize("kind", [BlockStarted, Telemetry])
def test_stop_is_answered_wherever_it_comes(execute_commands: Any, kind: type[Event]) -> None:
    control = RunControl()
    result, _ = execute_commands(
        {"action": "repeat", "times": 1000, "commands": [STOP]},
        control=control,
        listener=lambda _tick, event: control.stop() if isinstance(event, kind) else None,
    )
    assert result.ended.state == "stopped"


HEAVY = {
    "action": "conditional_execution",
    "condition": {"op": "or", "args": [{"op": "==", "args": [{"gesture": "result"}, "x"]}] * 3000},
    "commands": [],
    "block": "heavy",
}


def test_stop_is_answered_between_the_steps_of_a_tick(execute_commands: Any) -> None:
    control = RunControl()
    result, log = execute_commands(
        {"action": "repeat", "times": 100_000, "commands": [HEAVY]},
        control=control,
        listener=lambda _tick, event: (
            control.stop() if isinstance(event, BlockStarted) and event.block else None
        ),
    )
    assert result.ended.state == "stopped"
    assert len([event for event in of_type(log, BlockStarted) if event.block == "heavy"]) == 1


def test_long_conditions_count_as_many_steps_of_a_tick(execute_commands: Any) -> None:
    light, _ = execute_commands({"action": "repeat", "times": 100, "commands": [STOP]})
    heavy, _ = execute_commands({"action": "repeat", "times": 100, "commands": [HEAVY]})
    # 9,001 parts are 450 steps: two such conditions fit into a tick, not a thousand
    assert heavy.ended.duration_s * 30 == pytest.approx(100 / 3, abs=17)
    assert light.ended.state == heavy.ended.state == "finished"


@pytest.mark.parametrize(
    "command",
    [
        {"action": "wait", "seconds": 0},
        {"action": "move_forward", "distance": 0},
        {"action": "turn", "angle": 0},
        {"action": "arc", "radius": 1, "angle": 0},
        {"action": "go_to", "x": 0, "y": 0},
        {"action": "wait_until", "condition": True},
        {"action": "set_speed", "linear": 0.5},
    ],
    ids=lambda command: command["action"],
)
def test_commands_that_turn_out_to_take_no_time_are_reported_five_times_a_second(
    command: Any, execute_commands: Any
) -> None:
    result, log = execute_commands(
        {"action": "repeat", "times": 15_000, "commands": [{**command, "block": "b"}]}
    )
    ticks = [tick for tick, event in log if isinstance(event, BlockStarted) and event.block == "b"]
    assert result.ended.state == "finished"
    assert len(ticks) > 2
    assert all(following - earlier >= 5 for earlier, following in pairwise(ticks))


def test_command_that_takes_time_the_second_time_in_a_tick_is_reported_when_it_does(
    execute_commands: Any,
) -> None:
    _, log = execute_commands(
        {
            "action": "for",
            "variable": "i",
            "from": 0,
            "to": 1,
            "commands": [{"action": "wait", "seconds": {"var": "i"}, "block": "w"}],
        }
    )
    waits = [event for _, event in log if isinstance(event, BlockStarted) and event.block == "w"]
    assert [event.amount for event in waits] == [0, 1]
    assert len([e for _, e in log if isinstance(e, BlockEnded) and e.block == "w"]) == 2


COUNT = {"action": "forever", "commands": [{"action": "set_variable", "name": "n", "value": 1}]}


@pytest.mark.parametrize(
    ("commands", "reason"),
    [
        ([COUNT], "too_busy"),
        ([{"action": "drive", "linear": 0.1, "angular": 30}, COUNT], "too_busy"),
        ([{"action": "wait", "seconds": 60}, {"action": "turn", "angle": 360}], None),
    ],
)
def test_a_run_that_only_calculates_ends_at_a_limit_of_steps(
    commands: list[dict[str, Any]], reason: str | None
) -> None:
    program = read_document({"pinel_ir": 1, "commands": commands}).program
    assert program is not None
    options = RunOptions(step_limit=StepLimit(at_rest=20_000, total=60_000))
    ended = execute(program, open_link("sim", world="empty_room"), options).ended
    assert ended.reason == reason
