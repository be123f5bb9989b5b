"""Saying, beeping, asking."""

from typing import Any

import pytest

from pinel_desktop.events.model import Answered, Asked, Beeped, Event, TextShown
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.inputs import LiveInputs, ScriptedInputs
from tests.execution.wall import Wall

ASK = {"action": "ask", "question": "How far?", "variable": "far", "block": "a"}
BEEP = {"action": "beep", "block": "b"}


def say(text: Any) -> dict[str, Any]:
    return {"action": "say", "text": text, "block": "s"}


def of_type(log: Any, kind: type[Event]) -> list[Any]:
    return [event for _, event in log if isinstance(event, kind)]


def test_what_is_said_is_reported_in_order_and_kept(execute_commands: Any) -> None:
    result, log = execute_commands(say("Olá!"), say(3), say(0.5), say(True), say([1, "a"]))
    assert result.shown_texts == ["Olá!", "3", "0.5", "true", "1, a"]
    assert of_type(log, TextShown) == [TextShown("s", text) for text in result.shown_texts]
    assert result.ended.duration_s == 0


@pytest.mark.parametrize(
    ("command", "reason"),
    [(say("x"), "too_many_said"), (BEEP, "too_many_beeps")],
)
def test_thousand_are_enough(command: Any, reason: str, execute_commands: Any) -> None:
    thousand = {"action": "repeat", "times": 1_000, "commands": [command]}
    assert execute_commands(thousand)[0].ended.state == "finished"
    result, log = execute_commands(thousand, command)
    ended = result.ended
    assert (ended.reason, ended.params, ended.block) == (reason, {"max": 1000}, command["block"])
    assert len(of_type(log, TextShown) + of_type(log, Beeped)) == 1_000


def test_beep_is_reported(execute_commands: Any) -> None:
    _, log = execute_commands(BEEP, BEEP)
    assert of_type(log, Beeped) == [Beeped("b"), Beeped("b")]


@pytest.mark.parametrize(
    ("typed", "value"),
    [
        ("3", 3),
        (" -2.5 ", -2.5),
        ("1,5", 1.5),
        (".5", 0.5),
        ("+7", 7),
        ("Ana", "Ana"),
        (" Ana ", " Ana "),
        ("", ""),
        ("3 m", "3 m"),
        ("1e3", "1e3"),
        ("nan", "nan"),
        ("1.000,5", "1.000,5"),
        ("9" * 400, "9" * 400),
        ("٣", "٣"),
        ("a\ud800", "a?"),
    ],
)
def test_answer_that_reads_as_a_number_is_one(
    typed: str, value: Any, execute_commands: Any
) -> None:
    result, log = execute_commands(ASK, inputs=ScriptedInputs(answers=[typed]))
    assert result.variables == {"far": value}
    assert of_type(log, Asked) == [Asked("a", "How far?", "far")]
    assert of_type(log, Answered) == [Answered("far", value)]


def test_scripted_answer_comes_on_the_next_tick(execute_commands: Any) -> None:
    result, _ = execute_commands(ASK, ASK, inputs=ScriptedInputs(answers=["1", "2"]))
    assert result.variables == {"far": 2}
    assert round(result.ended.duration_s * 30) == 2 + 1  # and one to stand still


def test_question_without_an_answer_fails_in_words(execute_commands: Any) -> None:
    result, _ = execute_commands(ASK, ASK, inputs=ScriptedInputs(answers=["1"]))
    ended = result.ended
    assert (ended.reason, ended.block) == ("answer_missing", "a")
    assert ended.params == {"question": "How far?"}


def test_question_may_be_computed_and_must_be_a_text(execute_commands: Any) -> None:
    name = {"action": "set_variable", "name": "n", "value": 2}
    joined = {"op": "join", "args": ["Number ", {"var": "n"}, "?"]}
    _, log = execute_commands(
        name, {**ASK, "question": joined}, inputs=ScriptedInputs(answers=["1"])
    )
    assert of_type(log, Asked)[0].question == "Number 2?"
    result, _ = execute_commands(name, {**ASK, "question": {"var": "n"}})
    assert (result.ended.reason, result.ended.params) == ("wrong_type_text", {"name": "question"})


def test_person_answers_while_the_program_waits(execute_commands: Any) -> None:
    inputs, wall = LiveInputs(), Wall()
    inputs.answers.answer("too early")
    wall.at(40.0, lambda: inputs.answers.answer("Bia"))
    result, log = execute_commands(ASK, inputs=inputs, wall=wall.time)
    inputs.answers.answer("too late")
    assert result.variables == {"far": "Bia"}
    assert wall.passed_s == pytest.approx(40.0, abs=0.1)
    assert next(tick for tick, event in log if isinstance(event, Answered)) == 0


def test_answer_in_the_moment_of_the_question_counts(execute_commands: Any) -> None:
    inputs = LiveInputs()

    def answer(_tick: int, event: Event) -> None:
        if isinstance(event, Asked):
            inputs.answers.answer("now")

    result, _ = execute_commands(ASK, inputs=inputs, listener=answer, wall=Wall().time)
    assert result.variables == {"far": "now"}


def test_stop_ends_a_question(execute_commands: Any) -> None:
    control, wall = RunControl(), Wall()
    wall.at(1.0, control.stop)
    result, _ = execute_commands(ASK, inputs=LiveInputs(), control=control, wall=wall.time)
    assert (result.ended.state, result.ended.block) == ("stopped", "a")


def test_too_long_an_answer_fails_the_run(execute_commands: Any) -> None:
    result, _ = execute_commands(ASK, inputs=ScriptedInputs(answers=["x" * 10_001]))
    assert result.ended.reason == "text_too_long"


def test_loop_of_questions_ends(execute_commands: Any) -> None:
    loop = {"action": "forever", "commands": [ASK]}
    result, _ = execute_commands(loop, inputs=ScriptedInputs(answers=["x"] * 2_000))
    assert (result.ended.reason, result.ended.params) == ("too_many_questions", {"max": 1000})
