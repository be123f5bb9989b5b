"""The review names the run of a real robot that is out of the ordinary for it, in the lesson and among all runs."""

import math
from collections.abc import Iterator

import pytest
from playwright.sync_api import expect

from pinel_desktop.runs.record import record_of
from storage import RunRecorder, TruePoseRow
from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.conftest import OpenStudio
from tests.e2e.past_lesson import SQUARE, PastGroup, PastLesson, document_of, school_after
from tests.e2e.review_school import Past, Teacher, sign_in
from tests.e2e.test_layout import cut
from tests.runs.hidden_errors import drive

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

N_USUAL = 5
SENTENCE = "Fora do comum para este robô: girou"


def play(lesson: PastLesson) -> Past:
    """A group drives squares on a real robot under a camera; in the last one somebody pushes it."""
    lesson.at(2)
    tatus = lesson.group("Os Tatus")
    version = tatus.edit(*SQUARE)
    pushed = [None] * N_USUAL + [(5, -20.0)]
    runs = [
        filmed(lesson, tatus, version, minute, push) for minute, push in enumerate(pushed, start=3)
    ]
    return Past(lesson.lesson, "", tatus.id, runs)


def filmed(
    lesson: PastLesson,
    group: PastGroup,
    version: str,
    minute: int,
    pushed: tuple[int, float] | None,
) -> str:
    """Records a run of the double, and where a camera saw it."""
    lesson.at(minute)
    store = lesson.store
    double = drive(document_of(SQUARE), turns=0.97, pushed=pushed, seed=minute)
    record = record_of(double.spec, world_name="room", app_version="0.5", version_id=version)
    run = store.runs.begin(record).id
    recorder = RunRecorder(store)
    for event in double.wire:
        recorder({**event, "run": run})
    recorder.flush().result()
    recorder.close()
    group.judged(run, passed=True)
    poses = [(tick, *double.true[tick].tolist()) for tick in range(0, len(double.true), 3)]
    rows: list[TruePoseRow] = [
        (t, x, y, math.remainder(yaw, math.tau), 0.005, 0.01) for t, x, y, yaw in poses
    ]
    store.truths.record(run, "camera", rows)
    return run


@pytest.fixture(scope="module")
def school(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[AppProcess, Past]]:
    with school_after(tmp_path_factory.mktemp("real"), play) as school:
        yield school


@pytest.fixture
def app(school: tuple[AppProcess, Past]) -> AppProcess:
    return school[0]


@pytest.fixture
def teacher(open_studio: OpenStudio, school: tuple[AppProcess, Past]) -> Teacher:
    studio = open_studio()
    sign_in(studio)
    return Teacher(studio, school[1])


def test_the_pushed_run_is_named_among_all_runs_and_in_its_lesson(teacher: Teacher) -> None:
    teacher.go("runs")
    expect(teacher["history-run"]).to_have_count(N_USUAL + 1)
    named = teacher["history-run"].filter(has=teacher["unusual"])
    expect(named).to_have_count(1)
    expect(named).to_contain_text(SENTENCE)
    expect(named).to_contain_text("pela câmera.")
    assert violations(teacher.studio, "unusual") == []
    named.get_by_role("link").click()
    expect(teacher["prediction-line"]).to_contain_text("pela câmera")
    teacher.go(f"lesson/{teacher.past.lesson}")
    teacher["review-open"].click()
    lines = teacher["review-run"].filter(has=teacher["unusual"])
    expect(lines).to_have_count(1)
    expect(lines).to_contain_text(SENTENCE)
    expect(lines).to_contain_text("Nas outras 5 rodadas dele: girou 2,")
    assert violations(teacher.studio, "unusual") == []
    assert cut(teacher.studio, "unusual") == []
