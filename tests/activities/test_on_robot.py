"""Which activities a run on a real robot is judged for, and by which tolerances."""

from dataclasses import replace
from functools import cache
from typing import Any

import pytest

from pinel_desktop.activities import (
    Activity,
    LiveEvaluation,
    RecordedRun,
    RunLog,
    RunLogBuilder,
    activity_names,
    case_of_real_run,
    check_program,
    judging_blockers,
    not_judgeable_notice,
    not_judged_text,
    shipped_activity,
    solution_of,
    tolerance_of,
)
from pinel_desktop.activities.checking import spec_of
from pinel_desktop.activities.checks import KINDS
from pinel_desktop.activities.checks.base import CheckBase
from pinel_desktop.activities.recorded import Reason
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import LANGUAGES
from pinel_desktop.program.python_text import read_python
from pinel_desktop.program.reading import ParseResult, read_document
from pinel_desktop.program.sensors import SENSORS
from pinel_desktop.robot import SimulationConfig
from pinel_desktop.robot.robot_profile import BridgeProfile, Room
from pinel_desktop.runs.start import start
from tests.activities.given_programs import GivenProgram, wrong
from tests.activities.test_checks import SIMULATOR_ONLY, activity

BRIDGE = {"robot": BridgeProfile().as_record()}
JUDGED = (
    "dashed_line",
    "stairs",
    "square",
    "triangle",
    "polygon",
    "star",
    "lemniscate",
    "letter",
    "flower",
    "sign_b",
    "b_or_a",
    "until_b",
    "up_to_three_metres",
    "metres_by_fingers",
)
EMPTY = "empty_room"


def test_every_kind_declares_what_it_needs_of_the_simulator() -> None:
    assert {name: kind.requires for name, kind in KINDS.items() if "requires" in vars(kind)} == {
        name: SIMULATOR_ONLY.get(name) for name in KINDS
    }


def test_every_kind_with_a_tolerance_widens_it() -> None:
    tolerant = {"within_m", "within_deg", "tolerance", "at_most_m", "at_most_deg", "net_within"}
    for name, kind in KINDS.items():
        has_one = tolerant & kind.model_fields.keys()
        assert (kind.with_tolerance is not CheckBase.with_tolerance) == bool(
            has_one or name == "any_of"
        ) or name == "symmetric", name


def test_the_catalogue_is_judged_where_the_world_does_not_matter() -> None:
    found = {name for name in activity_names() if not judging_blockers(shipped_activity(name))}
    assert found == set(JUDGED)
    first = {
        name: judging_blockers(shipped_activity(name))[0].missing
        for name in activity_names()
        if name not in JUDGED
    }
    assert first.pop("pushing") == "boxes"
    assert set(first.values()) == {"zones"}


@pytest.mark.parametrize(
    ("more", "missing", "kinds"),
    [
        ({"checks": [{"check": "ends_in", "zone": "A"}]}, "zones", ("ends_in",)),
        ({"checks": [{"check": "touches_nothing"}], "world": EMPTY}, "contact", ("touches_nothing",)),
        ({"checks": [{"check": "time", "at_most_s": 9.0}], "world": EMPTY}, "pace", ("time",)),
        ({"world": "city_block"}, "boxes", ()),
        ({"world": "maze"}, "walls", ()),
        ({"world": EMPTY, "cases": [{}, {"start": {"x_m": 1.0, "y_m": 0.0}}]}, "starts", ()),
    ],
)  # fmt: skip
def test_what_only_the_simulator_tells_keeps_a_run_from_being_judged(
    more: dict[str, Any], missing: str, kinds: tuple[str, ...]
) -> None:
    mission = activity(**{"checks": [{"check": "finished"}], **more})
    assert judging_blockers(mission)[0] == (missing, kinds)


def test_one_of_several_checks_needs_what_each_of_them_needs() -> None:
    some = [{"check": "finished"}, {"check": "visits", "zones": ["A"]}]
    mission = activity({"check": "any_of", "checks": some})
    assert judging_blockers(mission) == (("zones", ("any_of",)),)


@pytest.mark.parametrize("sensor", sorted(SENSORS))
def test_a_solution_that_reads_the_world_needs_it(sensor: str) -> None:
    until = {"action": "wait_until", "condition": {"op": "==", "args": [{"sensor": sensor}, 1]}}
    document = {"pinel_ir": 1, "commands": [until]}
    mission = activity({"check": "finished"}, world=EMPTY, solution=document)
    own = {"x", "y", "heading", "time", "has_mark", "mark_here"}
    assert bool(judging_blockers(mission)) == (sensor not in own)


def test_every_reason_has_words_that_name_what_is_missing() -> None:
    reasons = ["zones", "boxes", "contact", "pace", "walls", "sensors", "starts"]
    for language in LANGUAGES:
        texts = {not_judged_text(reason, language) for reason in [*reasons, "inputs", "stopped"]}
        assert len(texts) == 9
    assert "lugares do mundo" in not_judged_text("zones", "pt-BR")
    assert not_judged_text("of a newer release", "en") == not_judged_text("failed", "en")
    assert "record" in str(Reason)
    assert not_judgeable_notice(shipped_activity("square"), "pt-BR") is None


def test_the_robot_s_record_decides_how_exactly_it_drives() -> None:
    coarse = {"robot": {**BridgeProfile().as_record(), "move_tolerance_m": 0.1}}
    fine, wide = tolerance_of(BRIDGE), tolerance_of(coarse)
    assert fine is not None
    assert wide is not None
    assert fine.move_m == pytest.approx(0.02)
    assert wide == replace(fine, move_m=wide.move_m)
    assert wide.move_m == pytest.approx(0.11)
    assert tolerance_of({"model": "pioneer_3dx"}) is None
    with pytest.raises(PinelError, match="run_damaged"):
        tolerance_of({"robot": {"move_tolerance_m": "wide"}})


def driven(mission: Activity, case: int, reading: ParseResult) -> RunLog:
    """What a real robot tells: the realistic simulator's run, of which nobody knows the true poses."""
    spec = spec_of(mission, mission.cases[case - 1], reading)
    writer = RunLogBuilder()

    def observe(tick: int, event: Any) -> None:
        if event.type == "telemetry":
            event = replace(event, true_x_m=None, true_y_m=None, true_yaw_rad=None)
        writer.observe(tick, event)

    start(
        replace(spec, setting=SimulationConfig(mission.model, "realistic", "pose"), seed=3), observe
    )
    return writer.log()


def judged(name: str, reading: ParseResult, case: int) -> bool:
    mission = shipped_activity(name)
    log = driven(mission, case, reading)
    assert not log.is_true
    number = case_of_real_run(mission, log)
    assert number is not None
    report = check_program(
        mission, reading, recorded=RecordedRun(log, number, tolerance_of(BRIDGE))
    )
    recorded_cases = [one for one in report.cases if one.recorded]
    assert len(recorded_cases) == 1
    return report.passed


@cache
def solution(name: str) -> ParseResult:
    return read_document(solution_of(name) or {})


@pytest.mark.parametrize("name", JUDGED)
def test_a_solution_passes_by_what_a_real_robot_measured(name: str) -> None:
    for case in range(1, len(shipped_activity(name).cases) + 1):
        assert judged(name, solution(name), case), case


WRONG = [given for given in wrong() if given.activity in JUDGED and "no_reading" not in given.name]


@pytest.mark.parametrize("given", WRONG, ids=str)
def test_a_wrong_program_does_not_pass_by_a_wider_tolerance(given: GivenProgram) -> None:
    assert not judged(given.activity, read_python(given.text).result, 1)


def test_inputs_that_no_case_gives_are_of_none() -> None:
    mission = shipped_activity("polygon")
    four = mission.model_copy(update={"cases": [check(["4"])]})
    log = driven(four, 1, solution("polygon"))
    assert case_of_real_run(mission, log) is None


def check(answers: list[str]) -> Any:
    return shipped_activity("polygon").cases[0].model_copy(update={"answers": answers})


def test_the_check_list_follows_a_real_run_and_says_what_counts_as_before() -> None:
    mission, reading = shipped_activity("square"), solution("square")
    assert reading.document is not None
    world = Room().as_world()
    evaluation = LiveEvaluation(
        mission, reading.document, world, SimulationConfig(), tolerance_of(BRIDGE)
    )
    assert evaluation.applies
    lines = evaluation.evaluate(driven(mission, 1, reading), "en")
    assert [line.state for line in lines] == ["met"] * len(mission.checks)
    assert "Drive 4 m in all" in [line.criterion for line in lines]
    maze = shipped_activity("maze")
    assert not LiveEvaluation(
        maze, reading.document, world, SimulationConfig(), tolerance_of(BRIDGE)
    ).applies
    assert mission.checks[0].requirements() == frozenset()
