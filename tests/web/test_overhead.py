"""The camera above the floor, over HTTP."""

from collections.abc import Iterator
from typing import Any

import pytest

from pinel_desktop.app import App
from pinel_desktop.settings import OVERHEAD
from tests.web.browser import Browser

MEASURES = {"width_m": 2.5, "depth_m": 2.0, "camera_m": 2.7, "robot_m": 0.25}


@pytest.fixture
def teacher(app: App, browser: Browser) -> Iterator[Browser]:
    browser.put("/api/teacher/pin", {"pin": "4711"})
    yield browser
    app._floor_camera.end_trial()


def test_measures_are_saved_and_the_camera_is_switched_off(app: App, teacher: Browser) -> None:
    assert teacher.get("/api/overhead").data["is_on"] is False
    assert teacher.put("/api/overhead", MEASURES).data == {"is_on": True, **MEASURES}
    assert app._settings[OVERHEAD] == "2500-2000-2700-250"
    assert teacher.delete("/api/overhead").data["is_on"] is False
    assert app._settings[OVERHEAD] == ""


def test_an_impossible_measure_is_refused_with_its_bounds(app: App, teacher: Browser) -> None:
    answer = teacher.put("/api/overhead", {**MEASURES, "camera_m": 0.1})
    assert answer.status == 422
    assert answer.data["error"]["code"] == "overhead_range"
    assert app._settings[OVERHEAD] == ""


def test_the_sheets_are_those_of_the_command(teacher: Browser) -> None:
    assert teacher.get("/api/overhead/sheets").data["page"].count("<section>") == 5


def test_a_trial_reports_what_the_camera_detects(app: App, teacher: Browser) -> None:
    assert teacher.post("/api/overhead/trial").data["error"]["code"] == "overhead_not_set_up"
    teacher.put("/api/overhead", MEASURES)
    assert teacher.post("/api/overhead/trial").data["code"] is None  # the camera starts
    message: dict[str, Any] = {
        "age_s": 0.0,
        "missing": [],
        "markers": [1, 2, 3, 4, 5],
        "problem": None,
    }
    app._overhead.receive({**message, "pose": [1.0, 0.5, 0.0, 0.004, 0.01]})
    seen = teacher.post("/api/overhead/trial").data
    assert (seen["code"], seen["params"]["x"], seen["markers"]) == (
        "overhead_seen",
        1.0,
        [1, 2, 3, 4, 5],
    )
    app._overhead.receive(
        {**message, "pose": None, "problem": "overhead_floor_missing", "missing": [3]}
    )
    seen = teacher.post("/api/overhead/trial").data
    assert "3" in seen["message"]
    assert seen["remedy"]
    assert teacher.delete("/api/overhead/trial").status == 200


def test_pupils_are_refused(browser: Browser) -> None:
    assert browser.get("/api/overhead").data["error"]["code"] == "pin_missing"
