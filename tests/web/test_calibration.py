"""Calibrated robots over HTTP: from real runs to a robot that groups choose in the simulator."""

import json
from typing import Any

import pytest

from pinel_desktop.app import App
from pinel_desktop.robot import simulation_config_from
from tests.calibration.recorded_runs import measured_pattern, real_run
from tests.web.browser import Browser

NAME = "Pioneer da sala 3"


@pytest.fixture
def teacher(app: App) -> Browser:
    tab = Browser.signed_in(app.address)
    tab.put("/api/teacher/pin", {"pin": "314159"})
    return tab


@pytest.fixture
def robot(app: App) -> str:
    """A calibrated robot."""
    return app._store.calibrated_robots.create(NAME, "pioneer_3dx", {"track_m": 0.345}, {}).id


def started(browser: Browser, version: Any, robot: str) -> Any:
    request = {"version_id": version["id"], "world": "empty_room", "calibrated_robot": robot}
    return browser.post("/api/runs", request)


def test_three_real_runs_become_a_robot_of_the_simulator(app: App, teacher: Browser) -> None:
    runs = measured_pattern(app._store)
    unmeasured, _ = real_run(app._store, "robot.move_forward(1)\n")
    listed = teacher.get("/api/real-runs").data["runs"]
    assert [(one["id"], one["sources"]) for one in listed] == [
        (unmeasured, []),
        *((run, ["tape"]) for run in reversed(runs)),
    ]
    report = teacher.post("/api/calibrations", {"runs": runs}).data
    track = report["parameters"][0]
    assert (track["name"], track["sources"], track["is_known"]) == ("track_m", ["tape"], True)
    assert track["low"] < report["values"]["track_m"] == track["value"] < track["high"]
    assert report["held_out"] == []
    assert [one["shape"] for one in listed] == ["line", "right", "left", "line"]
    made = teacher.post("/api/calibrated-robots", {"runs": runs, "title": NAME}).data
    assert made["title"] == NAME
    row = app._store.calibrated_robots.get(made["id"])
    assert row.parameters == report["values"]
    assert row.report["runs"] == runs


def test_real_runs_name_their_group(
    app: App, teacher: Browser, group: dict[str, Any], version: dict[str, Any]
) -> None:
    real_run(app._store, "robot.move_forward(1)\n", version_id=version["id"])
    real_run(app._store, "robot.move_forward(1)\n")
    listed = teacher.get("/api/real-runs").data["runs"]
    assert [one["group_name"] for one in listed] == [None, group["name"]]


def test_a_run_holds_the_robot_in_full_and_never_changes(
    app: App, browser: Browser, teacher: Browser, version: Any, robot: str
) -> None:
    run = started(browser, version, robot).data
    assert (run["calibrated_robot"], run["model"]) == (NAME, "pioneer_3dx")
    teacher.delete(f"/api/calibrated-robots/{robot}")
    row = app._store.runs.get(run["id"])
    setting = simulation_config_from(row.parameters)
    assert (setting.preset, setting.feedback) == ("realistic", "odometry")
    assert setting.parameters.changes == {"track_m": 0.345}
    assert browser.get(f"/api/runs/{run['id']}").data["calibrated_robot"] == NAME


def test_a_robot_that_is_not_there_is_named_and_no_run_starts(
    app: App, browser: Browser, teacher: Browser, version: Any, robot: str
) -> None:
    teacher.delete(f"/api/calibrated-robots/{robot}")
    deleted = started(browser, version, robot)
    assert deleted.error["code"] == "calibrated_robot_deleted"
    assert NAME in deleted.error["message"]
    unknown = started(browser, version, "0199e4a0-0000-7fff-bfff-ffffffffffff")
    assert unknown.error["code"] == "calibrated_robot_not_found"
    assert app._store.runs.newest(5) == []
    teacher.post(f"/api/calibrated-robots/{robot}/take-back")
    assert [one["id"] for one in browser.get("/api/calibrated-robots").data["robots"]] == [robot]


def test_a_version_names_its_robot_and_one_without_is_stored_as_before(
    app: App, browser: Browser, program: Any, robot: str
) -> None:
    setup = {"world": "empty_room"}
    for chosen in (None, robot):
        body = {"workspace": {}, "document": None, "setup": {**setup, "calibrated_robot": chosen}}
        saved = browser.post(f"/api/programs/{program['id']}/versions", body).data
        stored = app._store.versions.get(saved["id"]).setup
        assert stored is not None
        assert stored.get("calibrated_robot") == chosen
        assert ("calibrated_robot" in stored) == (chosen is not None)
        shown = browser.get(f"/api/versions/{saved['id']}").data["setup"]
        assert shown["calibrated_robot"] == chosen


def test_only_the_teacher_calibrates_and_refusals_are_words(
    app: App, browser: Browser, teacher: Browser, robot: str
) -> None:
    refused = [
        browser.get("/api/real-runs"),
        browser.post("/api/calibrations", {"runs": []}),
        browser.post("/api/calibrated-robots", {"runs": [], "title": "x"}),
        browser.delete(f"/api/calibrated-robots/{robot}"),
        browser.post(f"/api/calibrated-robots/{robot}/take-back"),
    ]
    assert {one.error["code"] for one in refused} == {"teacher_only"}
    none = teacher.post("/api/calibrations", {"runs": []})
    assert (none.status, none.error["code"]) == (422, "calibration_without_runs")
    assert json.dumps(none.error["remedy"])
