from typing import Any

import pytest

from pinel_desktop.events.model import CaptureStarted, Event, GestureResult
from pinel_desktop.execution.inputs import Capture, LiveInputs, ScriptedInputs
from tests.execution.wall import Wall

CLASSIFY = {"action": "classify_gestures", "timeout": 2, "block": "c"}


def test_scripted_result_arrives_on_the_next_tick(execute_commands: Any) -> None:
    result, log = execute_commands(CLASSIFY, inputs=ScriptedInputs(["B"]))
    assert result.gesture_result == "B"
    assert result.ended.duration_s * 30 == 1 + 1  # one to answer, one to stand still
    assert [event for _, event in log if isinstance(event, CaptureStarted)] == [
        CaptureStarted("c", 2.0)
    ]
    assert [event for _, event in log if isinstance(event, GestureResult)] == [
        GestureResult("B", "capture", "list")
    ]


def test_scripted_results_run_out_into_nothing_recognised(execute_commands: Any) -> None:
    result, _ = execute_commands(CLASSIFY, CLASSIFY, inputs=ScriptedInputs(["B"]))
    assert result.gesture_result == ""


def test_person_answers_while_the_capture_runs(execute_commands: Any) -> None:
    inputs, wall = LiveInputs(), Wall()
    wall.at(0.5, lambda: inputs.gestures.answer(Capture("L", "person")))
    result, log = execute_commands(CLASSIFY, inputs=inputs, wall=wall.time)
    assert result.gesture_result == "L"
    assert wall.passed_s == pytest.approx(0.5, abs=0.1)
    assert next(tick for tick, event in log if isinstance(event, GestureResult)) == 0


def test_answer_in_the_moment_the_capture_is_announced_counts(execute_commands: Any) -> None:
    inputs = LiveInputs()

    def answer(_tick: int, event: Event) -> None:
        if isinstance(event, CaptureStarted):
            inputs.gestures.answer(Capture("L", "person"))

    result, _ = execute_commands(CLASSIFY, inputs=inputs, listener=answer, wall=Wall().time)
    assert result.gesture_result == "L"


def test_unanswered_capture_ends_after_its_timeout_with_nothing(execute_commands: Any) -> None:
    wall = Wall()
    result, _ = execute_commands(CLASSIFY, inputs=LiveInputs(), wall=wall.time)
    assert result.gesture_result == ""
    assert wall.passed_s == pytest.approx(2.0, abs=0.1)
    assert result.ended.duration_s == 0.0


def test_answer_outside_a_capture_is_not_kept_for_the_next(execute_commands: Any) -> None:
    inputs = LiveInputs()
    inputs.gestures.answer(Capture("B", "person"))
    result, _ = execute_commands(CLASSIFY, inputs=inputs, wall=Wall().time)
    assert result.gesture_result == ""


def test_repeating_a_result_reports_it_once(execute_commands: Any) -> None:
    _, log = execute_commands(
        {
            "action": "repeat",
            "times": 9,
            "commands": [{"action": "set_gesture_result", "result": "A"}],
        }
    )
    assert len([event for _, event in log if isinstance(event, GestureResult)]) == 1


def test_results_set_in_a_loop_without_motion_are_reported_once_a_tick(
    execute_commands: Any,
) -> None:
    both = [{"action": "set_gesture_result", "result": letter} for letter in "AB"]
    result, log = execute_commands({"action": "repeat", "times": 5000, "commands": both})
    ticks = [tick for tick, event in log if isinstance(event, GestureResult)]
    assert len(ticks) == len(set(ticks))
    assert len(ticks) > 5
    assert result.gesture_result == "B"


READ = {"action": "read_number", "timeout": 2, "block": "n"}
SHOW = {"action": "say", "text": {"gesture": "number"}}
DRIVE = {"action": "move_forward", "distance": {"gesture": "number"}}


def test_number_shown_is_a_number_and_leaves_the_sign_as_it_is(execute_commands: Any) -> None:
    inputs = ScriptedInputs(["B", "3"])
    result, log = execute_commands(CLASSIFY, READ, DRIVE, SHOW, inputs=inputs)
    assert result.shown_texts == ["3"]
    assert result.gesture_result == "B"
    assert result.ended.pose["x_m"] == pytest.approx(3.0, abs=1e-3)
    assert [event for _, event in log if isinstance(event, CaptureStarted)] == [
        CaptureStarted("c", 2.0),
        CaptureStarted("n", 2.0, "number"),
    ]
    assert [event for _, event in log if isinstance(event, GestureResult)][1:] == [
        GestureResult("3", "capture", "list", what="number")
    ]


@pytest.mark.parametrize("shown", ["", "B", "11", "-1", "3.0", " 3", "²"])
def test_number_shown_is_minus_one_where_nobody_showed_one(
    execute_commands: Any, shown: str
) -> None:
    result, log = execute_commands(READ, SHOW, inputs=ScriptedInputs([shown]))
    assert result.shown_texts == ["-1"]
    [given] = [event for _, event in log if isinstance(event, GestureResult)]
    assert (given.result, given.what) == ("", "number")


def test_number_shown_is_minus_one_before_any_capture_and_after_a_timeout(
    execute_commands: Any,
) -> None:
    assert execute_commands(SHOW)[0].shown_texts == ["-1"]
    wall = Wall()
    result, _ = execute_commands(READ, SHOW, inputs=LiveInputs(), wall=wall.time)
    assert result.shown_texts == ["-1"]
    assert wall.passed_s == pytest.approx(2.0, abs=0.1)


def test_driving_without_a_number_fails_in_words_at_its_block(execute_commands: Any) -> None:
    result, _ = execute_commands(READ, {**DRIVE, "block": "d"})
    assert (result.ended.state, result.ended.reason) == ("failed", "no_number_shown")
    assert result.ended.block == "d"
    half = {**DRIVE, "distance": {"op": "/", "args": [{"gesture": "number"}, 2]}}
    assert execute_commands(READ, half)[0].ended.reason == "distance_out_of_range"


def test_number_shown_may_be_too_large_as_any_number(execute_commands: Any) -> None:
    wait = {"action": "set_speed", "linear": {"gesture": "number"}}
    result, _ = execute_commands(READ, wait, inputs=ScriptedInputs(["9"]))
    assert result.ended.reason == "speed_out_of_range"


def test_turning_by_no_number_is_a_turn_by_minus_one_degree(execute_commands: Any) -> None:
    turn = {"action": "turn", "angle": {"gesture": "number"}}
    assert execute_commands(READ, turn)[0].ended.state == "finished"
