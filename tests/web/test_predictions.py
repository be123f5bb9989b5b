"""Predictions of real robots' runs over HTTP, live and recorded, with the judge's real process."""

import math
from typing import Any

import pytest

from pinel_desktop.app import App
from pinel_desktop.errors import PinelError
from pinel_desktop.robot.robot_profile import profile_from
from pinel_desktop.school.predictions import Predictions
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


def begin(browser: Browser, document: Any = SQUARE, robot: str = "bridge", **more: Any) -> str:
    body = {"version_id": saved(browser, document), "world": "empty_room", "robot": robot, **more}
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
    measured(browser, run, double)
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


def calibrated(app: App, **more: Any) -> str:
    """A calibrated robot that turns 10 degrees less in a turn than it believes, and states how sure it is."""
    wheels = {
        "believed_track_m": 0.33,
        "parameters": [1.0, 0.0, 0.33 * 360 / 350],
        "covariance": [[1e-5, 0.0, 0.0], [0.0, 1e-6, 0.0], [0.0, 0.0, 1e-6]],
        "wheel_noise": 0.02,
        "n_poses": 9,
    }
    parameters = {"track_m": 0.33 * 360 / 350, "wheel_noise": 0.02, "lag_s": 0.06}
    report = {"wheels": wheels, **more}
    robot = app._store.calibrated_robots.create("Pioneer", "pioneer_3dx", parameters, report)
    return robot.id


def measured(browser: Browser, run: str, double: Driven) -> None:
    tick, pose, sigma_m, sigma_rad = double.tape
    names = ("tick", "x_m", "y_m", "heading_rad", "sigma_m", "sigma_rad")
    row = dict(zip(names, (tick, *pose, sigma_m, sigma_rad), strict=True))
    put = browser.put(f"/api/runs/{run}/truths/tape", {"poses": [row]})
    assert put.status == 200, put.data


def test_the_chosen_calibrated_robot_predicts_and_states_its_error_also_when_it_was_deleted(
    app: App, browser: Browser, teacher: Browser, engine: FakeEngine
) -> None:
    robot = calibrated(app)
    run = begin(browser, calibrated_robot=robot)
    double = drive(run=run, turns=350 / 360)
    for event in double.wire:
        engine.send(event)
    found = of(browser, run)
    assert found["robot"] == "Pioneer"
    assert 0.03 < found["within_m"] < 0.2
    # truly it turns less; its odometry does not know, and is as predicted
    assert found["path"][-1][3] == pytest.approx(math.radians(350), abs=0.02)
    assert found["difference"]["source"] == "odometry"
    assert found["difference"]["findings"] == []
    measured(browser, run, double)
    teacher.delete(f"/api/calibrated-robots/{robot}")
    whole = of(browser, run)
    end = whole["difference"]["at_end"]
    assert whole["difference"]["is_whole"]
    assert end["source"] == "tape"
    assert end["distance_m"] <= whole["within_m"]
    assert abs(end["heading_deg"]) < 2.0


def test_without_a_choice_the_robot_that_was_calibrated_from_this_one_predicts(
    app: App, browser: Browser, teacher: Browser, engine: FakeEngine
) -> None:
    others, _ = driven(browser, engine)
    assert of(browser, others)["robot"] is None
    profile = profile_from(app._store.runs.get(others).parameters["robot"])
    calibrated(app, robot=["bridge", "another place"])
    run, _ = driven(browser, engine)
    assert of(browser, run)["robot"] is None
    calibrated(app, robot=[profile.link, profile.address])
    run, _ = driven(browser, engine)
    assert of(browser, run)["robot"] == "Pioneer"
    # a chosen robot that is not there is no reason to keep a real robot from driving
    run = begin(browser, calibrated_robot="0199e4a0-0000-7fff-bfff-ffffffffffff")
    assert "predicted_by" not in app._store.runs.get(run).parameters


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


def test_a_difference_that_a_lost_judge_could_not_compute_is_computed_later(
    app: App, engine: FakeEngine, teacher: Browser
) -> None:
    run, _ = driven(teacher, engine)
    judges = iter([LostJudge(), app._grader.judge])
    predictions = Predictions(app._store, lambda: next(judges))  # type: ignore[arg-type, return-value]
    assert predictions._difference(run) is None
    assert predictions._difference(run) is not None
    assert predictions._difference(run) is not None  # from memory


class LostJudge:
    """A judge whose process exits at each request."""

    def predict(self, request: object) -> None:
        raise PinelError("judge_lost")
