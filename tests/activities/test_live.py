"""The check list of a run that goes on: filled by the code of the verdict, never ahead of the run."""

import re
from functools import cache

import pytest

from pinel_desktop.activities import (
    CheckStatus,
    LiveEvaluation,
    RunLogBuilder,
    activity_names,
    choose_activity,
    initial_check_list,
    judge_run,
    solution_of,
    world_of,
)
from pinel_desktop.activities.checking import spec_of
from pinel_desktop.activities.checks import KINDS
from pinel_desktop.activities.checks.movement.ends_at import EndsAt
from pinel_desktop.events.model import Event
from pinel_desktop.execution.control import RunControl
from pinel_desktop.messages import LANGUAGES
from pinel_desktop.program.python_text import read_python
from pinel_desktop.program.reading import ParseResult, read_document
from pinel_desktop.robot import SimulationConfig
from pinel_desktop.runs.start import start
from tests.activities.given_programs import GivenProgram, others, wrong
from tests.activities.test_checks import ONE_OF_EACH

ENDLESS = ("until_b/wrong_no_reading", "maze/wrong_no_move")
GIVEN = [given for given in (*wrong(), *others()) if str(given) not in ENDLESS]
OFTEN, RARELY = 15, 600  # ticks

States = list[tuple[str, str, str]]


@cache
def read(text: str) -> ParseResult:
    return read_python(text).result


def followed(
    name: str, reading: ParseResult, case: int = 1, language: str = "en", every: int = OFTEN
) -> list[States]:
    """The check list after so many ticks of a case again and again, and at its end."""
    activity = choose_activity(name)
    spec = spec_of(activity, activity.cases[case - 1], reading)
    assert reading.document is not None
    world = world_of(activity, activity.cases[case - 1])
    evaluation = LiveEvaluation(activity, reading.document, world, spec.setting)
    assert evaluation.applies
    writer, snapshots = RunLogBuilder(), []

    def observe(tick: int, event: Event) -> None:
        writer.observe(tick, event)
        if tick % every == 0 and event.type == "telemetry":
            snapshots.append(statuses(evaluation.evaluate(writer.log(), language)))

    start(spec, observe, RunControl())
    last = statuses(evaluation.evaluate(writer.log(), language))
    report = judge_run(activity, case, reading.document, writer.log())
    # several cases may have begun alike; then the first of them is meant
    if len(report.checks) == len(last):
        assert [state == "met" for _, _, state in last] == [one.holds for one in report.checks]
    return [*snapshots, last]


def statuses(lines: list[CheckStatus]) -> States:
    return [(one.criterion, one.measured, one.state) for one in lines]


def states_of(criterion: str, lists: list[States]) -> list[str]:
    """What a line says one after the other, without repetitions."""
    found = [state for lines in lists for label, _, state in lines if label == criterion]
    return [state for i, state in enumerate(found) if i == 0 or found[i - 1] != state]


def solution(name: str) -> ParseResult:
    document = solution_of(name)
    assert document is not None
    return read_document(document)


def test_a_square_fills_the_list_side_by_side() -> None:
    lists = followed("square", solution("square"))
    assert states_of("Reach the end of the program", lists) == ["open", "met"]
    assert states_of("Drive 4 m in all", lists) == ["open", "met"]
    assert states_of("A square with sides of 1 m", lists) == ["open", "met"]
    measured = [
        progress for lines in lists for label, progress, _ in lines if label == "Drive 4 m in all"
    ]
    assert "1 m driven" in measured
    assert measured[-1] == "4 m driven"


def test_standing_at_the_start_is_no_return_to_it() -> None:
    assert states_of("End at the start", followed("square", solution("square"))) == ["open", "met"]


def test_what_was_touched_stays_touched() -> None:
    lists = followed("to_the_bakery", read("robot.move_forward(30)\n"))
    assert states_of("Touch nothing", lists) == ["met", "broken"]
    assert lists[-1][1][1].startswith("touched at ")
    assert states_of("End in “padaria · bakery”", lists) == ["open", "met", "open", "broken"]


def test_what_the_program_lacks_is_said_before_the_robot_has_moved_far() -> None:
    lists = followed("stairs", read("robot.move_forward(1)\n"))
    assert states_of("Use “repeat”", lists) == ["broken"]
    assert states_of("Use up to 8 blocks", lists) == ["met"]


def test_a_path_that_is_too_long_will_not_become_shorter() -> None:
    lists = followed(
        "square", read("for _ in range(5):\n    robot.move_forward(1)\n    robot.turn(90)\n")
    )
    assert states_of("Drive 4 m in all", lists) == ["open", "met", "broken"]


def test_the_checks_of_a_case_come_with_its_sign() -> None:
    reading = solution("sign_b")
    lists = followed("sign_b", reading, case=1)
    common = [label for label, _, _ in lists[0]][:2]
    assert common == ["Reach the end of the program", "Show a sign"]
    assert states_of("Show a sign", lists)[-1] == "met"
    assert states_of("End 1 m ahead, seen from the start", lists)[-1] == "met"
    assert states_of("Stay in place", followed("sign_b", reading, case=2)) == ["met"]


def test_a_run_in_another_world_is_not_followed() -> None:
    activity, other = choose_activity("square"), choose_activity("maze")
    ideal = SimulationConfig(activity.model, activity.preset, activity.feedback)
    assert not LiveEvaluation(activity, {}, world_of(other, other.cases[0]), ideal).applies
    shaky = SimulationConfig(activity.model, "realistic", activity.feedback)
    assert not LiveEvaluation(activity, {}, world_of(activity, activity.cases[0]), shaky).applies


@pytest.mark.parametrize("given", GIVEN, ids=str)
def test_the_list_ends_as_the_verdict_and_has_no_open_ends(given: GivenProgram) -> None:
    reading = read(given.text)
    lists = followed(given.activity, reading, language="pt-BR", every=RARELY)
    for label, measured, _ in (line for lines in lists for line in lines):
        assert not re.search(r"[{}_]", label + measured)
    assert all(state != "open" for _, _, state in lists[-1])


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_kind_of_check_has_a_line(language: str) -> None:
    lines = set()
    for name, kind in KINDS.items():
        line = kind.model_validate({"check": name, **ONE_OF_EACH.get(name, {})}).line(language)
        assert not re.search(r"[{}_]", line), name
        lines.add(line)
    assert len(lines) == len(KINDS)


def test_places_are_said_as_seen_from_the_start() -> None:
    there = EndsAt(check="ends_at", x_m=-1.0, y_m=2.5)
    assert there.line("pt-BR") == "Terminar 1 m atrás e 2,5 m à esquerda da partida"


@pytest.mark.parametrize("name", activity_names())
def test_before_a_run_every_line_is_open(name: str) -> None:
    lines = initial_check_list(choose_activity(name), "pt-BR")
    assert lines[0].criterion == "Chegar ao fim do programa"
    assert {(one.state, one.measured) for one in lines} == {("open", "")}
