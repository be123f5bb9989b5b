"""Predictions of real robots' runs over HTTP, live and recorded, with the judge's real process."""

import math
from typing import Any

import pytest

from pinel_desktop.app import App
from tests.links.aurora import free_port
from tests.live_runs import saved
from tests.runs.hidden_errors import PROFILE, SQUARE, TURN, Driven, drive
from tests.web.browser import Browser
from tests.web.fake_engine import FakeEngine

PIN = "314159"
ASKING = {
    "pinel_ir": 1,
    "commands": [
        TURN,
        {"action": "ask", "question": "?", "variable": "a", "block": "ask"},
        {"action": "turn", "angle": {"var": "a"}, "block": "by_answer"},
    ],
}


@pytest.fixture
def teacher(app: App) -> Browser:
    """The teacher, who has set up a robot."""
    teacher = Browser.signed_in(app.address)
    teacher.put("/api/teacher/pin", {"pin": PIN})
    record = {**PROFILE.as_message(), "port": free_port()}
    del record["link"]
    answer = teacher.put("/api/real-robots/bridge", {"record": record})
    assert answer.status == 200, answer.data
    return teacher


def begin(browser: Browser, document: Any = SQUARE, robot: str = "bridge") -> str:
    body = {"version_id": saved(browser, document), "world": "empty_room", "robot": robot}
    return str(browser.post("/api/runs", body).data["id"])


def driven(browser: Browser, engine: FakeEngine, **errors: Any) -> tuple[str, Driven]:
    """A run of the double, as the engine delivers it."""
    run = begin(browser)
    double = drive(run=run, **errors)
    for event in double.wire:
        engine.send(event)
    return run, double


def of(browser: Browser, run: str) -> dict[str, Any]:
    answer = browser.get(f"/api/runs/{run}/prediction")
    assert answer.status == 200, answer.data
    found: dict[str, Any] = answer.data
    return found


def code_of(browser: Browser, run: str) -> tuple[int, str]:
    answer = browser.get(f"/api/runs/{run}/prediction")
    return answer.status, answer.data["error"]["code"]


def test_a_recorded_run_is_compared_by_odometry_and_by_a_tape_measure_once_it_is_measured(
    browser: Browser, teacher: Browser, engine: FakeEngine
) -> None:
    run, double = driven(browser, engine, turns=1 - 3.1 / 90)
    found = of(browser, run)
    assert found["difference"]["source"] == "odometry"
    assert [one["kind"] for one in found["difference"]["findings"]] == []
    assert [step["block"] for step in found["steps"]] == ["ahead", "turn"] * 4
    assert found["path"][-1][1:] == pytest.approx([0, 0, math.tau], abs=0.01)
    tick, pose, sigma_m, sigma_rad = double.tape
    names = ("tick", "x_m", "y_m", "heading_rad", "sigma_m", "sigma_rad")
    measured = dict(zip(names, (tick, *pose, sigma_m, sigma_rad), strict=True))
    put = browser.put(f"/api/runs/{run}/truths/tape", {"poses": [measured]})
    assert put.status == 200, put.data
    (finding, *_) = of(browser, run)["difference"]["findings"]
    assert (finding["source"], finding["how"], finding["n"]) == ("tape", "average", 4)
    assert finding["difference"] == pytest.approx(-3.1, abs=0.3)


def test_the_prediction_of_a_live_run_goes_on_when_the_answer_came(
    browser: Browser, teacher: Browser, engine: FakeEngine
) -> None:
    run = begin(browser, ASKING)
    double = drive(ASKING, answers=("45",), run=run)
    n_before = next(i for i, event in enumerate(double.wire) if event["type"] == "answered")
    for event in double.wire[:n_before]:
        engine.send(event)
    found = of(browser, run)
    assert found["awaits_input"]
    assert [step["block"] for step in found["steps"]] == ["turn"]
    engine.send(double.wire[n_before])
    found = of(browser, run)
    assert not found["awaits_input"]
    assert [step["block"] for step in found["steps"]] == ["turn", "by_answer"]


def test_runs_without_a_prediction_say_why(
    app: App, browser: Browser, teacher: Browser, engine: FakeEngine
) -> None:
    simulated = begin(browser, robot="sim")
    for event in drive(run=simulated).wire:
        engine.send(event)
    assert code_of(browser, simulated) == (409, "prediction_simulated")
    earlier, _ = driven(browser, engine)
    app._store._database.write(  # as a release before profiles recorded it
        lambda db: db.execute(
            "UPDATE runs SET parameters = json_remove(parameters, '$.robot') WHERE id = ?",
            [earlier],
        )
    )
    assert code_of(browser, earlier) == (409, "prediction_no_robot")
    assert code_of(browser, "unknown") == (404, "run_not_found")


def test_the_unusual_run_of_a_robot_is_listed_for_the_teacher(
    browser: Browser, teacher: Browser, engine: FakeEngine
) -> None:
    for seed in range(5):
        filmed(browser, *driven(browser, engine, seed=seed, turns=0.97))
    assert teacher.get("/api/unusual-runs").data["runs"] == []
    outlier, double = driven(browser, engine, seed=7, turns=0.97, pushed=(5, -20.0))
    filmed(browser, outlier, double)
    assert browser.get("/api/unusual-runs").status == 403
    (found,) = teacher.get("/api/unusual-runs").data["runs"]
    assert (found["run"], found["kind"], found["block"]) == (outlier, "turn", "turn")
    assert (found["source"], found["n_runs"]) == ("camera", 5)
    assert found["difference"] == pytest.approx(-22.7, abs=1.0)
    assert found["usual"] == pytest.approx(-2.7, abs=0.5)


def filmed(browser: Browser, run: str, double: Driven) -> None:
    """Records where a camera saw the robot of a run."""
    poses = [(tick, *map(float, double.true[tick])) for tick in range(0, len(double.true), 3)]
    body = [
        {"tick": t, "x_m": x, "y_m": y, "heading_rad": math.remainder(yaw, math.tau)}
        | {"sigma_m": 0.005, "sigma_rad": 0.01}
        for t, x, y, yaw in poses
    ]
    answer = browser.put(f"/api/runs/{run}/truths/camera", {"poses": body})
    assert answer.status == 200, answer.data
