"""During a run of an activity, the page gets its check results."""

import time

import pytest

from pinel_desktop.activities import Activity
from pinel_desktop.app import App
from pinel_desktop.school import grading
from pinel_desktop.school.live_checks import pause_after_s
from pinel_desktop.school.own_activities import known_activity
from pinel_desktop.web.api import runs
from storage import Store
from tests.in_time import in_time
from tests.storage.sample_runs import ended, sample
from tests.web.browser import Browser
from tests.web.conftest import SQUARE
from tests.web.fake_engine import FakeEngine

CHECK_STATUS = "checks_stand"


def begin(app: App, browser: Browser, activity: str | None) -> str:
    store = app._store
    classroom = store.classrooms.create("9º A").id
    if activity:
        store.lessons.open(classroom, "Aula 1", activity)
    group = store.groups.create("Os Robôs", classroom_id=classroom).id
    program = store.programs.create(group, "Quadrado").id
    version = {"workspace": {}, "document": SQUARE}
    saved = browser.post(f"/api/programs/{program}/versions", version).data["id"]
    response = browser.post("/api/runs", {"version_id": saved, "world": "empty_room"})
    return str(response.data["id"])


def state_of(event: dict[str, object], criterion: str) -> object:
    checks = event["checks"]
    assert isinstance(checks, list)
    return next(line["state"] for line in checks if line["criterion"] == criterion)


def test_the_list_fills_while_the_run_goes_on(
    app: App, browser: Browser, engine: FakeEngine
) -> None:
    with browser.stream() as events:
        run = begin(app, browser, "square")
        engine.send(sample(run, 1))
        first = events.until(CHECK_STATUS)[-1]
        assert first["run"] == run
        assert state_of(first, "Drive 4 m in all") == "open"
        for tick in range(2, 403):
            engine.send(sample(run, tick))
        assert state_of(events.until(CHECK_STATUS)[-1], "Drive 4 m in all") == "met"
        for tick in range(403, 450):
            engine.send(sample(run, tick))
        assert state_of(events.until(CHECK_STATUS)[-1], "Drive 4 m in all") == "broken"
        engine.send(ended(run, 450, 449))
        last = events.until(CHECK_STATUS)[-1]
        assert state_of(last, "Reach the end of the program") == "met"
        assert state_of(last, "End at the start") == "broken"


def test_the_list_speaks_the_chosen_language(
    app: App, browser: Browser, engine: FakeEngine
) -> None:
    browser.put("/api/settings", {"language": "pt-BR"})
    with browser.stream() as events:
        run = begin(app, browser, "square")
        engine.send(sample(run, 1))
        assert state_of(events.until(CHECK_STATUS)[-1], "Terminar na partida") == "open"
        engine.send(ended(run, 2, 1))


def test_a_run_without_activity_is_not_followed(
    app: App, browser: Browser, engine: FakeEngine
) -> None:
    run = begin(app, browser, None)
    engine.send(sample(run, 1))
    assert app._live_checks._run is None
    engine.send(ended(run, 2, 1))


def test_an_app_that_closes_waits_for_no_run(
    app: App, browser: Browser, engine: FakeEngine
) -> None:
    run = begin(app, browser, "square")
    engine.send(sample(run, 1))
    start_s = time.monotonic()
    app._live_checks.close()
    assert in_time(time.monotonic() - start_s, 2)


@pytest.mark.parametrize(("judging_s", "pause_s"), [(0.01, 0.5), (0.2, 1.8), (8.0, 10.0)])
def test_a_slow_answer_of_the_judge_keeps_nobody_waiting_for_a_minute(
    judging_s: float, pause_s: float
) -> None:
    assert pause_after_s(judging_s) == pytest.approx(pause_s)


def test_the_activity_of_a_run_is_read_once(
    app: App, browser: Browser, engine: FakeEngine, monkeypatch: pytest.MonkeyPatch
) -> None:
    """When it begins: check list and verdict have it from then on."""
    read: list[str] = []

    def counted(store: Store, name: str) -> Activity:
        read.append(name)
        return known_activity(store, name)

    for module in (runs, grading):
        monkeypatch.setattr(module, "known_activity", counted)
    with browser.stream() as events:
        run = begin(app, browser, "square")
        engine.send(sample(run, 1))
        events.until(CHECK_STATUS)
        engine.send(ended(run, 2, 1))
        events.until("judged")
    assert read == ["square"]
