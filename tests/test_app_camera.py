"""The whole app with a camera: signs decide what the robot does, and the run is repeated without a camera."""

import os
import signal
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import cv2
import pytest

from pinel_desktop.app import App
from pinel_desktop.camera.landmark_sequence import read_landmark_sequence
from pinel_desktop.engine.client import EngineClient
from pinel_desktop.gestures.training.photos import read_photos
from pinel_desktop.runs.verification import verify_run
from storage import open_store
from tests.camera.taught_hands import packed, shown, write_unknown_hand
from tests.in_time import in_time
from tests.live_runs import command, saved, start_run
from tests.web.browser import Browser, Stream

pytestmark = pytest.mark.waits

RECORDINGS = Path(__file__).parent / "camera" / "recordings"
PHOTOS = os.environ.get("PINEL_LIBRAS", "")
WAIT_S = 60.0


def regular(n: int) -> list[dict[str, Any]]:
    """A small polygon of n sides."""
    side = [{"action": "move_forward", "distance": 0.05}, {"action": "turn", "angle": 360 / n}]
    return [{"action": "repeat", "times": n, "commands": side}]


SIGNS_AND_POLYGONS = {
    "pinel_ir": 1,
    "name": "signs",
    "commands": [
        {
            "action": "repeat",
            "times": 2,
            "commands": [
                {"action": "classify_gestures", "timeout": 30, "block": "c"},
                {
                    "action": "conditional_execution",
                    "condition": "result == 'B'",
                    "commands": regular(4),
                    "elif": [{"condition": "result == 'A'", "commands": regular(3)}],
                    "else": [],
                },
            ],
        }
    ],
}


@pytest.fixture
def app(tmp_path: Path) -> Iterator[App]:
    with App(tmp_path / "pinel.db", camera=str(RECORDINGS / "b.npz")) as app:
        yield app


@pytest.fixture
def browser(app: App) -> Browser:
    return signed_in(app)


def signed_in(app: App) -> Browser:
    """A browser of an app whose engine is ready."""
    engine = app._engine
    assert isinstance(engine, EngineClient)
    assert engine.wait_until_ready(WAIT_S)
    return Browser.signed_in(app.address)


def results(events: list[dict[str, Any]]) -> list[dict[str, Any]]:
    return [event for event in events if event["type"] == "gesture_result"]


def test_signs_decide_what_the_robot_draws_and_the_run_is_identical_without_a_camera(
    app: App, browser: Browser, tmp_path: Path
) -> None:
    version_id = saved(browser, SIGNS_AND_POLYGONS)
    with browser.stream() as stream:
        stream.next()
        run = start_run(browser, version_id)
        events = stream.until("gesture_result")
        app._camera.set_source(str(RECORDINGS / "a.npz"))
        events += stream.until("run_ended")
    gestures = results(events)
    assert [(result["result"], result["by"]) for result in gestures] == [
        ("B", "camera"),
        ("A", "camera"),
    ]
    assert all(0.5 < result["confidence"] <= 1.0 for result in gestures)
    assert events[-1]["state"] == "finished"
    assert events[-1]["n_executed"] == 2 + 4 * 2 + 3 * 2
    app.close()
    with open_store(tmp_path / "pinel.db") as store:
        assert verify_run(store, store.runs.get(run)).outcome == "identical"


def test_a_sign_that_the_class_taught_decides_too_and_the_run_is_identical_without_a_camera(
    tmp_path: Path,
) -> None:
    taught_hand = write_unknown_hand(tmp_path / "strange.npz")
    document = {
        "pinel_ir": 1,
        "name": "go",
        "commands": [
            capture(30),
            {
                "action": "conditional_execution",
                "condition": "result == 'VAI'",  # capitals do not matter
                "commands": regular(3),
            },
        ],
    }
    with App(tmp_path / "pinel.db", camera=str(taught_hand)) as app:
        browser = signed_in(app)
        classroom = app._store.classrooms.create("5º B").id
        hands = [hand for hands in read_landmark_sequence(taught_hand)[:10] for hand in hands]
        app._store.taught_signs.add(classroom, "vai", packed(hands))
        group = app._store.groups.create("Onças", classroom_id=classroom)
        program = app._store.programs.create(group.id, "P")
        path = f"/api/programs/{program.id}/versions"
        content = {"workspace": {"blocks": {}}, "document": document, "world": None}
        version_id = browser.post(path, content).data["id"]
        with browser.stream() as stream:
            stream.next()
            run = start_run(browser, version_id)
            events = stream.until("run_ended")
    (result,) = results(events)
    assert (result["result"], result["by"]) == ("vai", "taught")
    assert events[-1]["n_executed"] == 1 + 3 * 2
    with open_store(tmp_path / "pinel.db") as store:
        assert verify_run(store, store.runs.get(run)).outcome == "identical"


@pytest.mark.skipif(not PHOTOS, reason="PINEL_LIBRAS names no folder of photographs")
def test_signs_in_pictures_decide_what_the_robot_draws(tmp_path: Path) -> None:
    for letter in "AB":
        (tmp_path / letter).mkdir()
        photos = [photo for photo in read_photos(Path(PHOTOS)) if photo.source == "p2_webcam"]
        picture = next(photo for photo in photos if photo.letter == letter).picture()
        cv2.imwrite(str(tmp_path / letter / "hand.png"), cv2.cvtColor(picture, cv2.COLOR_RGB2BGR))
    with App(tmp_path / "pinel.db", camera=str(tmp_path / "B")) as app:
        browser = signed_in(app)
        version_id = saved(browser, SIGNS_AND_POLYGONS)
        with browser.stream() as stream:
            stream.next()
            start_run(browser, version_id)
            events = stream.until("gesture_result")
            app._camera.set_source(str(tmp_path / "A"))
            events += stream.until("run_ended")
    assert [(one["result"], one["by"]) for one in results(events)] == [
        ("B", "camera"),
        ("A", "camera"),
    ]


def test_person_may_answer_while_the_camera_looks(browser: Browser) -> None:
    version_id = saved(browser, {**SIGNS_AND_POLYGONS, "commands": [capture(20)]})
    with browser.stream() as stream:
        stream.next()
        run = start_run(browser, version_id)
        stream.until("capture_started")
        command(browser, run, "answer_capture", result="L")
        (result,) = results(stream.until("run_ended"))
    assert (result["result"], result["by"], result["confidence"]) == ("L", "person", None)


@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGSTOP])
def test_stop_is_not_late_when_the_camera_fails_in_the_middle_of_a_capture(
    app: App, browser: Browser, how: signal.Signals
) -> None:
    version_id = saved(browser, {**SIGNS_AND_POLYGONS, "commands": [capture(60)]})
    app._camera.start()
    assert app._camera.wait_until_ready(WAIT_S)
    os.kill(app._camera.pid or 0, how)
    app._camera.set_taught_signs(
        (("B", 5 * packed(shown("B")[:10]), b""),)
    )  # more than a pipe takes
    with browser.stream() as stream:
        stream.next()
        run = start_run(browser, version_id)
        stream.until("capture_started")
        start_s = time.monotonic()
        command(browser, run, "stop")
        assert stream.until("run_ended")[-1]["state"] == "stopped"
    assert in_time(time.monotonic() - start_s, 1.0)


def test_capture_without_a_camera_waits_for_a_person(tmp_path: Path) -> None:
    with App(tmp_path / "pinel.db", camera="9") as app:
        browser = signed_in(app)
        version_id = saved(browser, {**SIGNS_AND_POLYGONS, "commands": [capture(60)]})
        with browser.stream() as stream:
            stream.next()
            run = start_run(browser, version_id)
            until_failed(stream)
            command(browser, run, "answer_capture", result="B")
            (result,) = results(stream.until("run_ended"))
    assert (result["result"], result["by"]) == ("B", "person")


def until_failed(stream: Stream) -> None:
    while stream.until("camera_state")[-1]["state"] != "failed":
        pass


def capture(timeout_s: float) -> dict[str, Any]:
    return {"action": "classify_gestures", "timeout": timeout_s, "block": "c"}
