"""A run that the store recorded is judged as the run was that it records; and which case of an activity it was."""

import json
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from pinel_desktop.activities import (
    RecordedRun,
    RunLog,
    case_of_run,
    check_program,
    choose_activity,
    run_log,
)
from pinel_desktop.activities.faults import world_of
from pinel_desktop.cli import main
from pinel_desktop.commands.world_file import choose_world
from pinel_desktop.messages import LANGUAGES
from pinel_desktop.program.python_text import read_python
from pinel_desktop.program.reading import ParseResult
from pinel_desktop.robot import simulation_config_from
from storage import RunRow, open_for_reading
from storage.runs.telemetry import STEPS
from tests.activities.given_programs import GivenProgram, solutions, wrong

ENDLESS = ("until_b/wrong_no_reading", "maze/wrong_no_move", "x_against_list/wrong_nobody_wins")
GIVEN = [given for given in (*solutions(), *wrong()) if str(given) not in ENDLESS]


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("PINEL_HOME", str(tmp_path))
    monkeypatch.setenv("PINEL_LANG", "en")
    return tmp_path


def solution_of(name: str) -> GivenProgram:
    return next(given for given in solutions() if given.activity == name)


@cache
def read(text: str) -> ParseResult:
    return read_python(text).result


def recorded(given: GivenProgram, folder: Path, case: int, *options: str) -> tuple[RunRow, RunLog]:
    """Runs a program as a case of its activity, records it, and reads it back."""
    activity = choose_activity(given.activity)
    file = folder / f"{given.name}.py"
    file.write_text(given.text, "utf-8")
    chosen_case = activity.cases[case - 1]
    world = folder / "world.json"
    world.write_text(json.dumps(world_of(activity, chosen_case)), "utf-8")
    arguments = [
        "--db",
        str(folder / "pinel.db"),
        "run",
        str(file),
        "--json",
        "--world",
        str(world),
    ]
    if chosen_case.gestures:
        # an empty text would be no list at all
        arguments += ["--gestures", ",".join(chosen_case.gestures) or ","]
    if chosen_case.answers:
        arguments += ["--answers", ",".join(chosen_case.answers)]
    done = CliRunner().invoke(main, [*arguments, *options])
    run_id = json.loads(done.stdout)["run_id"]
    with open_for_reading(folder / "pinel.db") as store:
        telemetry, events = store.runs.telemetry(run_id), store.runs.events(run_id)
        return store.runs.get(run_id), RunLog.of_columns(telemetry.column, events)


def test_evidence_rounds_as_the_record_does() -> None:
    for name in ("x_m", "y_m", "true_x_m", "true_y_m"):
        assert STEPS[name] == run_log.STEP_M
    assert STEPS["yaw_rad"] == STEPS["true_yaw_rad"] == run_log.STEP_RAD
    assert STEPS["done"] == run_log.STEP_DONE


@pytest.mark.parametrize("given", GIVEN, ids=str)
def test_the_recorded_run_gets_the_findings_of_the_run_itself(
    given: GivenProgram, tmp_path: Path
) -> None:
    activity = choose_activity(given.activity)
    last = len(activity.cases)
    _, log = recorded(given, tmp_path, last)
    live = check_program(activity, read(given.text))
    again = check_program(activity, read(given.text), recorded=RecordedRun(log, last))
    assert again.cases[last - 1].recorded
    assert replace(again.cases[last - 1], recorded=False) == live.cases[last - 1]
    assert again.advice == live.advice


@pytest.mark.parametrize(
    ("name", "case"),
    [("sign_b", 3), ("b_or_a", 4), ("metres_by_fingers", 4), ("cell_by_sign", 4)],
)
def test_a_run_in_which_nobody_showed_a_sign_does_not_pass(
    name: str, case: int, tmp_path: Path
) -> None:
    activity, solution = choose_activity(name), solution_of(name)
    row, log = recorded(solution, tmp_path, case)
    results = {"gesture_result": {"by": None}}  # as after a timeout
    nobody = replace(
        log, events=tuple({**one, **results.get(one["type"], {})} for one in log.events)
    )
    setting = simulation_config_from(row.parameters)
    assert case_of_run(activity, row.world_document, setting, nobody) == case
    report = check_program(activity, read(solution.text), recorded=RecordedRun(nobody, case))
    failed = [one.kind for number in report.cases for one in number.checks if not one.holds]
    assert failed == ["sign_shown"]
    assert report.advice is not None
    assert report.advice.words["pt-BR"].startswith("Ninguém mostrou um sinal nesta rodada.")
    assert check_program(activity, read(solution.text), recorded=RecordedRun(log, case)).passed


def test_of_a_run_whose_engine_was_lost_no_block_is_to_blame(tmp_path: Path) -> None:
    square = solution_of("square")
    _, log = recorded(square, tmp_path, 1)
    lost = {**log.ended, "state": "failed", "reason": "engine_lost"}
    cut = replace(log, events=(*log.events[: len(log.events) // 2], lost))
    report = check_program(
        choose_activity("square"), read(square.text), recorded=RecordedRun(cut, 1)
    )
    assert not report.passed
    assert report.advice is not None
    assert report.advice.block is None
    assert report.advice.words["pt-BR"] == (
        "O simulador parou de repente e foi ligado de novo. "
        "O programa está salvo. Apertem Rodar outra vez."
    )
    assert [check.block for check in report.cases[0].checks if check.kind == "finished"] == [None]


@pytest.mark.parametrize(
    ("name", "case"),
    [
        ("square", 1),
        ("stop_before_wall", 2),
        ("polygon", 3),
        ("up_to_three_metres", 4),
        ("b_or_a", 3),
        ("metres_by_fingers", 2),
    ],
)
def test_a_run_is_recognised_as_the_case_that_it_was(name: str, case: int, tmp_path: Path) -> None:
    row, log = recorded(solution_of(name), tmp_path, case)
    activity = choose_activity(name)
    setting = simulation_config_from(row.parameters)
    assert case_of_run(activity, row.world_document, setting, log) == case
    other: dict[str, Any] = world_of(choose_activity("maze"))
    assert case_of_run(activity, other, setting, log) is None
    assert case_of_run(activity, {}, setting, log) is None
    realistic = replace(setting, preset="realistic")
    assert case_of_run(activity, row.world_document, realistic, log) is None


def test_the_world_of_a_shipped_activity_has_its_title_in_every_language() -> None:
    world = world_of(choose_activity("maze"))
    assert set(world["title"]) == set(LANGUAGES)
    assert world["title"]["pt-BR"] == "Labirinto"
    assert choose_world("maze", robot="pioneer_3dx").document == world
