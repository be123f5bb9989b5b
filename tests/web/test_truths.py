"""Where a real robot truly was, over HTTP."""

import math
from typing import Any

import pytest

from pinel_desktop.app import App
from pinel_desktop.robot.robot_profile import Room
from storage import RunStart
from tests.storage.bundle_makers import a_run
from tests.storage.sample_documents import SQUARE
from tests.web.browser import Browser

END = {
    "tick": None,
    "x_m": 1.02,
    "y_m": 0.03,
    "heading_rad": 0.1,
    "sigma_m": 0.01,
    "sigma_rad": 0.03,
}


@pytest.fixture
def run(app: App) -> str:
    """A run on a real robot in a room of four by four metres, from its centre."""
    world = Room().as_world()
    return app._store.runs.begin(RunStart("dds", "room", world, 1, "0.3", document=SQUARE)).id


def poses(*found: dict[str, Any]) -> dict[str, Any]:
    return {"poses": list(found)}


def test_a_measurement_is_stored_with_the_run_and_can_be_removed(
    browser: Browser, run: str
) -> None:
    address = f"/api/runs/{run}/truths"
    assert browser.get(address).data == {"truths": [], "believed": None, "run_s": 0.0}
    (tape,) = browser.put(f"{address}/tape", poses(END)).data["truths"]
    assert (tape["source"], tape["poses"]) == ("tape", [END])
    assert browser.get(address).data["truths"] == [tape]
    assert browser.put(f"{address}/tape", poses()).data["truths"] == []


@pytest.mark.parametrize(
    ("change", "code"),
    [
        ({"x_m": 1000}, "truth_range"),
        ({"x_m": 3.5}, "truth_outside_room"),
        ({"sigma_rad": math.tau}, "truth_range"),
        ({"x_m": "far"}, None),
        ({"note": 1}, None),
    ],
)
def test_what_cannot_be_is_refused_in_words(
    browser: Browser, run: str, change: dict[str, Any], code: str | None
) -> None:
    answer = browser.put(f"/api/runs/{run}/truths/tape", poses({**END, **change}))
    assert answer.status == 422
    assert answer.data["error"]["message"]
    assert code in (None, answer.data["error"]["code"])
    assert browser.get(f"/api/runs/{run}/truths").data["truths"] == []


def test_an_unknown_source_and_a_run_in_the_simulator_are_refused(
    app: App, browser: Browser, run: str
) -> None:
    assert browser.put(f"/api/runs/{run}/truths/guess", poses(END)).status in (404, 422)
    start = RunStart("sim", "w", Room().as_world(), 1, "0.3", document=SQUARE)
    simulated = app._store.runs.begin(start).id
    answer = browser.put(f"/api/runs/{simulated}/truths/tape", poses(END))
    assert answer.data["error"]["code"] == "truth_of_simulator"


def test_the_estimate_of_the_robot_is_in_the_answer_too(app: App, browser: Browser) -> None:
    run = a_run(app._store, None)
    believed = browser.get(f"/api/runs/{run}/truths").data["believed"]
    assert believed["x_m"] == pytest.approx(app._store.runs.telemetry(run).column("x_m")[-1])


def test_the_time_with_a_pose_of_the_camera_is_reported(browser: Browser, run: str) -> None:
    seen = [{**END, "tick": tick} for tick in (*range(31), *range(60, 91))]  # covered for a second
    (camera,) = browser.put(f"/api/runs/{run}/truths/camera", poses(*seen)).data["truths"]
    assert camera["covered_s"] == 2.0
