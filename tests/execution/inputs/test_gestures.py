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
