"""Signs over HTTP: the letters, and the signs that a class teaches. A landmark sequence replaces the webcam."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.app import App
from pinel_desktop.gestures.letters import LETTERS
from tests.camera.taught_hands import packed, shown
from tests.web.browser import Browser

pytestmark = pytest.mark.waits

RECORDING = Path(__file__).parents[1] / "camera" / "recordings" / "b.npz"


@pytest.fixture
def app(tmp_path: Path) -> Iterator[App]:
    with App(tmp_path / "pinel.db", camera=str(RECORDING)) as app:
        yield app


@pytest.fixture
def browser(app: App) -> Browser:
    return Browser.signed_in(app.address)


@pytest.fixture
def classroom(app: App) -> str:
    return app._store.classrooms.create("5º B").id


def taught(browser: Browser, classroom: str) -> dict[str, int]:
    signs = browser.get(f"/api/classrooms/{classroom}/signs").data["signs"]
    return {sign["name"]: sign["n_samples"] for sign in signs if sign["n_samples"]}


def known(app: App) -> list[str]:
    """Returns the taught signs that the camera should recognise."""
    return [sign for sign, *_ in app._camera._taught]


def record(browser: Browser, classroom: str, sign: str) -> list[dict[str, Any]]:
    """Records a sign until its samples are stored; returns the events."""
    with browser.stream() as stream:
        path = f"/api/classrooms/{classroom}/signs/{sign}/samples"
        answer = browser.post(path)
        assert answer.status == 200, answer.body
        events = []
        for event in stream.events():
            if event["type"] == "sign_recording":
                events.append(event)
                if event["is_kept"] or event["code"]:
                    return events
    raise AssertionError("the stream ended")


def test_letters_are_known_untaught(browser: Browser, classroom: str) -> None:
    none = {"is_letter": True, "n_samples": 0, "n_movements": 0, "landmarks": None}
    letters = [{"name": name, **none} for name in LETTERS]
    assert browser.get("/api/signs").data["signs"] == letters
    assert browser.get(f"/api/classrooms/{classroom}/signs").data["signs"] == letters
    assert browser.get("/api/classrooms/x/signs").error["code"] == "classroom_not_found"


def test_a_sign_is_recorded_listed_used_and_deleted(
    app: App, browser: Browser, classroom: str
) -> None:
    assert browser.put("/api/camera/classroom", {"classroom_id": classroom}).status == 200
    events = record(browser, classroom, "b")
    assert [event["n_samples"] for event in events] == [*range(11), 10]
    assert {event["sign"] for event in events} == {"B"}
    assert taught(browser, classroom) == {"B": 10}
    assert known(app) == ["B"]
    assert record(browser, classroom, "vai%20a%C3%AD")[-1]["is_kept"]
    assert taught(browser, classroom) == {"B": 10, "vai aí": 10}
    assert browser.delete(f"/api/classrooms/{classroom}/signs/B").status == 200
    assert taught(browser, classroom) == {"vai aí": 10}
    assert known(app) == ["vai aí"]
    response = browser.delete(f"/api/classrooms/{classroom}/signs/B")
    assert (response.status, response.error["code"]) == (404, "taught_sign_not_found")


def test_what_cannot_be_taught_is_told(app: App, browser: Browser, classroom: str) -> None:
    def refused(classroom_id: str, sign: str) -> tuple[int, str]:
        answer = browser.post(f"/api/classrooms/{classroom_id}/signs/{sign}/samples")
        return answer.status, answer.error["code"]

    assert refused("x", "7") == (404, "classroom_not_found")
    assert refused(classroom, "%3F") == (422, "sign_name_wrong")
    assert refused(classroom, "a" * 31) == (422, "sign_name_wrong")
    assert refused(classroom, "%20") == (422, "name_empty")


def test_a_recording_that_is_given_up_says_so(browser: Browser, classroom: str) -> None:
    with browser.stream() as stream:
        browser.post(f"/api/classrooms/{classroom}/signs/7/samples")
        assert browser.delete("/api/signs/recording").status == 200
        report = next(event for event in stream.events() if event.get("code"))
    assert (report["type"], report["code"]) == ("sign_recording", "sign_recording_stopped")
    assert report["remedy"]
    assert taught(browser, classroom) == {}


def test_a_run_brings_the_signs_of_its_group(app: App, browser: Browser, classroom: str) -> None:
    record(browser, classroom, "7")
    browser.put("/api/camera/classroom", {"classroom_id": None})
    assert known(app) == []
    group = app._store.groups.create("Onças", classroom_id=classroom)
    program = app._store.programs.create(group.id, "P")
    document = {"pinel_ir": 1, "name": "p", "functions": [], "commands": []}
    version = app._store.versions.save(program.id, {}, document)
    app._engine.wait_until_ready(30)
    response = browser.post("/api/runs", {"version_id": version.id, "world": "empty_room"})
    assert response.status == 200, response.body
    assert known(app) == ["7"]


def test_the_camera_forgets_the_signs_of_a_class_that_is_deleted(
    app: App, browser: Browser, classroom: str
) -> None:
    record(browser, classroom, "7")
    browser.put("/api/camera/classroom", {"classroom_id": classroom})
    assert known(app) == ["7"]
    browser.put("/api/teacher/pin", {"pin": "314159"})
    assert browser.delete(f"/api/classrooms/{classroom}").status == 200
    assert known(app) == []


def test_a_class_that_is_deleted_while_it_records_keeps_nothing_and_is_told(
    app: App, browser: Browser, classroom: str
) -> None:
    browser.put("/api/teacher/pin", {"pin": "314159"})
    with browser.stream() as stream:
        browser.post(f"/api/classrooms/{classroom}/signs/7/samples")
        assert browser.delete(f"/api/classrooms/{classroom}").status == 200
        report = next(event for event in stream.events() if event.get("code"))
    assert (report["type"], report["code"]) == ("sign_recording", "classroom_not_found")


def test_of_two_windows_that_record_the_second_one_does(browser: Browser, classroom: str) -> None:
    with browser.stream() as stream:
        browser.post(f"/api/classrooms/{classroom}/signs/7/samples")
        browser.post(f"/api/classrooms/{classroom}/signs/8/samples")
        outcomes = []
        for event in stream.events():
            if event["type"] == "sign_recording" and (event["is_kept"] or event["code"]):
                outcomes.append((event["sign"], event["code"]))
                if event["is_kept"]:
                    break
    assert outcomes == [("7", "sign_recording_stopped"), ("8", None)]
    assert taught(browser, classroom) == {"8": 10}


def test_a_sign_of_the_class_can_be_drawn_and_a_letter_has_its_drawing(
    app: App, browser: Browser, classroom: str
) -> None:
    for sign in ("B", "vai"):
        app._store.taught_signs.add(classroom, sign, packed(shown("B")[:10]))
    listed = browser.get(f"/api/classrooms/{classroom}/signs").data["signs"]
    landmarks = {sign["name"]: sign["landmarks"] for sign in listed}
    assert landmarks["B"] is None
    assert [len(landmark) for landmark in landmarks["vai"]] == [3] * 21


def test_whoever_lists_the_signs_hears_that_they_are_others(
    app: App, browser: Browser, classroom: str
) -> None:
    with browser.stream() as stream:
        record(browser, classroom, "7")
        assert stream.until("signs_changed")[-1]["classroom"] == classroom
        browser.delete(f"/api/classrooms/{classroom}/signs/7")
        assert stream.until("signs_changed")[-1]["classroom"] == classroom
        browser.put("/api/teacher/pin", {"pin": "314159"})
        browser.delete(f"/api/classrooms/{classroom}")
        assert stream.until("signs_changed")[-1]["classroom"] is None
    response = browser.put("/api/camera/classroom", {"classroom_id": classroom})
    assert response.error["code"] == "classroom_not_found"


def test_signs_of_another_pc_are_known_at_once(
    app: App, browser: Browser, classroom: str, tmp_path: Path
) -> None:
    browser.put("/api/camera/classroom", {"classroom_id": classroom})
    browser.put("/api/teacher/pin", {"pin": "2468"})
    bundle = browser.post("/api/bundles", {"folder": str(tmp_path), "classroom_id": classroom})
    with App(tmp_path / "other" / "pinel.db") as other:
        other_browser = Browser.signed_in(other.address)
        other_browser.put("/api/teacher/pin", {"pin": "2468"})
        other_browser.post("/api/bundles/merge", {"paths": [bundle.data["path"]]})
        other._store.taught_signs.add(classroom, "vai", packed(shown("B")[:10]))
        (tmp_path / "back").mkdir()
        back = other_browser.post("/api/bundles", {"folder": str(tmp_path / "back")})
    assert known(app) == []
    merged = browser.post("/api/bundles/merge", {"paths": [back.data["path"]]})
    assert merged.data["merged"][0]["problem"] is None
    assert known(app) == ["vai"]
