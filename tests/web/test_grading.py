"""Grading: after a run of a lesson with an activity, the result is stored and published on the stream."""

from collections.abc import Callable
from typing import Any

import pytest

from pinel_desktop.app import App
from pinel_desktop.errors import PinelError
from tests.storage.sample_runs import ended
from tests.web.browser import Browser
from tests.web.conftest import SQUARE
from tests.web.fake_engine import FakeEngine

Begin = Callable[..., str]


@pytest.fixture
def begin(app: App, browser: Browser) -> Begin:
    """Starts a run of a group whose class has a lesson with the activity "square"."""
    store = app._store
    classroom = store.classrooms.create("9º A").id
    store.lessons.open(classroom, "Aula 1", "square")
    group = store.groups.create("Os Robôs", classroom_id=classroom).id
    program = store.programs.create(group, "Quadrado").id

    def run(document: dict[str, Any] = SQUARE, world: str = "empty_room") -> str:
        version = {"workspace": {"of": len(str(document))}, "document": document}
        saved = browser.post(f"/api/programs/{program}/versions", version).data["id"]
        run_data = browser.post("/api/runs", {"version_id": saved, "world": world}).data
        assert (run_data["activity"], run_data["passed"]) == ("square", None)
        return str(run_data["id"])

    return run


@pytest.mark.parametrize(
    ("commands", "state", "passed", "missing", "block"),
    [
        (SQUARE["commands"], "finished", True, None, None),
        (
            [{"action": "move_forward", "distance": 1, "block": "kL0p"}],
            "finished",
            False,
            "The path is 1 m long; it needs at least 3.95 m. Look at “move forward 1 m”.",
            "kL0p",
        ),
        (SQUARE["commands"], "stopped", False, None, None),
    ],
)
def test_a_run_that_has_ended_is_judged(
    browser: Browser,
    engine: FakeEngine,
    begin: Begin,
    commands: list[dict[str, Any]],
    state: str,
    passed: bool,
    missing: str | None,
    block: str | None,
) -> None:
    with browser.stream() as events:
        run = begin({**SQUARE, "commands": commands})
        engine.send(ended(run, 0, 0, state=state))
        judged = events.until("judged")[-1]
    assert judged == {
        "type": "judged",
        "run": run,
        "passed": passed,
        "missing": missing,
        "block": block,
        "cases": [],
        "by_robot": False,
        "not_judged": None,
    }
    found = browser.get(f"/api/runs/{run}").data
    assert (found["passed"], found["missing"]) == (passed, missing)
    assert found["missing_block"] == block


def test_a_run_in_another_world_than_the_activity_s_is_told_that_first(
    browser: Browser, engine: FakeEngine, begin: Begin
) -> None:
    with browser.stream() as events:
        run = begin({**SQUARE, "commands": [{"action": "move_forward", "distance": 9}]}, "maze")
        engine.send(ended(run, 0, 0, state="failed"))
        missing = events.until("judged")[-1]["missing"]
        assert missing == "a run in the world “Empty room”, which is chosen above the floor."
        passes = begin(world="maze")
        engine.send(ended(passes, 0, 0))
        assert events.until("judged")[-1]["passed"] is True


def test_what_could_not_be_judged_is_judged_at_the_next_start(
    app: App, engine: FakeEngine, begin: Begin
) -> None:
    run = begin()
    app._grader.close()
    engine.send(ended(run, 0, 0))
    app._flush_recording()
    assert app._store.grading_results.pending() == [run]
    again = type(app._grader)(app._store, lambda: None, lambda event: None, lambda: "en")
    again.catch_up()
    again._worker.shutdown()
    again.close()
    assert app._store.grading_results.pending() == []
    assert app._store.runs.get(run).passed is True


def test_a_run_whose_end_could_not_be_written_is_judged_when_the_disk_has_room(
    app: App, browser: Browser, engine: FakeEngine, begin: Begin
) -> None:
    def limit(pages: int) -> None:
        app._store._database.write(
            lambda db: db.execute(f"PRAGMA max_page_count = {pages}").fetchone()
        )

    run = begin()
    with browser.stream() as events:
        events.next()
        limit(1)  # less than the present size
        engine.send({**ended(run, 0, 0), "text": "x" * 100_000})
        events.until("run_ended")
        app._grader._worker.submit(lambda: None).result()  # has passed the run over
        limit(100_000)
        assert events.until("judged")[-1]["run"] == run
    assert app._store.runs.get(run).check_report is not None


class LostJudge:
    """A judge whose process exits at each request."""

    def __init__(self) -> None:
        self.n_asked = 0

    def start(self) -> None: ...
    def close(self) -> None: ...

    def judge(self, question: object) -> None:
        self.n_asked += 1
        raise PinelError("judge_lost")


def test_a_run_whose_judge_dies_is_kept_for_the_next_start_and_the_group_is_told(
    app: App, engine: FakeEngine, begin: Begin
) -> None:
    app._grader.close()
    run, published, judge = begin(), list[dict[str, Any]](), LostJudge()
    engine.send(ended(run, 0, 0))
    app._flush_recording()
    lost = type(app._grader)(app._store, lambda: None, published.append, lambda: "en", judge)  # type: ignore[arg-type]
    lost.grade(run)
    lost._worker.shutdown()
    assert judge.n_asked == 2
    missing = "This run could not be checked. It is kept. Run again."
    verdict = {"passed": False, "missing": missing, "block": None, "cases": []}
    assert published == [
        {"type": "judged", "run": run, **verdict, "by_robot": False, "not_judged": None}
    ]
    assert app._store.grading_results.pending() == [run]


def test_no_judge_is_started_once_the_grader_is_closed(app: App) -> None:
    grader = type(app._grader)(app._store, lambda: None, lambda event: None, lambda: "en")
    grader.close()
    with pytest.raises(PinelError, match="judge_lost"):
        _ = grader.judge


def test_a_run_without_activity_is_not_judged(
    app: App, engine: FakeEngine, run: dict[str, Any]
) -> None:
    engine.send(ended(run["id"], 0, 0))
    app._grader.close()
    found = app._store.runs.get(run["id"])
    assert (found.activity, found.passed, found.check_report) == (None, None, None)
