"""What reads the signs, over HTTP: the landmarks, or a detector that the teacher puts on this PC."""

import urllib.parse
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.app import App
from pinel_desktop.gestures.letters import LETTERS
from tests.gestures.colour_detector import GREEN, METADATA, model, write_detector, write_pictures
from tests.web.browser import ApiResponse, Browser

pytestmark = pytest.mark.waits

ROUTE = "/api/camera/recognizers"


@pytest.fixture
def pictures(tmp_path: Path) -> Path:
    return write_pictures(tmp_path / "green", GREEN)


@pytest.fixture
def app(tmp_path: Path, pictures: Path) -> Iterator[App]:
    with App(tmp_path / "pinel.db", camera=str(pictures)) as app:
        yield app


@pytest.fixture
def browser(app: App) -> Browser:
    browser = Browser.signed_in(app.address)
    assert browser.put("/api/teacher/pin", {"pin": "2468"}).status == 200
    return browser


def add(browser: Browser, name: str, content: bytes) -> ApiResponse:
    path = f"{ROUTE}?name={urllib.parse.quote(name)}"
    octets = {"Content-Type": "application/octet-stream"}
    return browser.send("POST", path, body=content, headers=octets)


def signs(browser: Browser) -> list[str]:
    return [sign["name"] for sign in browser.get("/api/signs").data["signs"]]


def test_a_detector_is_added_chosen_and_removed(browser: Browser, tmp_path: Path) -> None:
    first = browser.get(ROUTE).data
    assert (first["chosen"], first["in_use"], first["detectors"]) == ("", "", [])
    added: Any = add(browser, "Sinais da Ana.onnx", model().SerializeToString()).data
    assert (added["chosen"], added["in_use"]) == ("Sinais-da-Ana",) * 2
    assert (added["detectors"], added["signs"]) == (["Sinais-da-Ana"], ["A", "B"])
    assert signs(browser) == ["A", "B"]
    assert (tmp_path / "detectors" / "Sinais-da-Ana.onnx").is_file()
    chosen = browser.put(ROUTE, {"name": ""}).data
    assert (chosen["chosen"], chosen["detectors"]) == ("", ["Sinais-da-Ana"])
    assert signs(browser) == list(LETTERS)
    assert browser.put(ROUTE, {"name": "Sinais-da-Ana"}).data["in_use"] == "Sinais-da-Ana"
    removed = browser.delete(f"{ROUTE}/Sinais-da-Ana").data
    assert (removed["chosen"], removed["in_use"], removed["detectors"]) == ("", "", [])
    assert list((tmp_path / "detectors").iterdir()) == []


def test_the_choice_is_remembered(tmp_path: Path, pictures: Path) -> None:
    write_detector(tmp_path / "x.onnx")
    for is_first in (True, False):
        with App(tmp_path / "pinel.db", camera=str(pictures)) as app:
            browser = Browser.signed_in(app.address)
            if is_first:
                browser.put("/api/teacher/pin", {"pin": "2468"})
                add(browser, "x.onnx", (tmp_path / "x.onnx").read_bytes())
            else:
                browser.post("/api/teacher/enter", {"pin": "2468"})
                assert browser.get(ROUTE).data["chosen"] == "x"


@pytest.mark.parametrize(
    ("name", "content", "code"),
    [
        ("text.onnx", b"no model", "detector_unreadable"),
        ("best.pt", b"PK", "detector_type_wrong"),
        (
            "other.onnx",
            model({**METADATA, "task": "pose"}).SerializeToString(),
            "detector_task_wrong",
        ),
    ],
)
def test_a_file_that_is_no_detector_is_refused_and_not_stored(
    browser: Browser, tmp_path: Path, name: str, content: bytes, code: str
) -> None:
    add(browser, "good.onnx", model().SerializeToString())
    refused = add(browser, name, content)
    assert (refused.status, refused.error["code"]) == (422, code)
    assert refused.error["remedy"]
    now = browser.get(ROUTE).data
    assert (now["chosen"], now["in_use"], now["detectors"]) == ("good", "good", ["good"])


def test_a_new_file_replaces_the_one_of_its_name_only_if_it_is_usable(
    browser: Browser, tmp_path: Path
) -> None:
    kept = tmp_path / "detectors" / "x.onnx"
    add(browser, "x.onnx", model().SerializeToString())
    before = kept.read_bytes()
    assert add(browser, "x.onnx", b"no model").error["code"] == "detector_unreadable"
    assert kept.read_bytes() == before
    assert browser.get(ROUTE).data["signs"] == ["A", "B"]
    other = model({**METADATA, "names": "['C', 'L']"}).SerializeToString()
    assert add(browser, "x.onnx", other).data["signs"] == ["C", "L"]
    assert kept.read_bytes() == other


def test_a_chosen_file_that_is_missing_is_named_and_the_landmarks_answer(
    tmp_path: Path, pictures: Path
) -> None:
    for is_first in (True, False):
        with App(tmp_path / "pinel.db", camera=str(pictures)) as app:
            browser = Browser.signed_in(app.address)
            if is_first:
                browser.put("/api/teacher/pin", {"pin": "2468"})
                add(browser, "x.onnx", model().SerializeToString())
            else:
                browser.post("/api/teacher/enter", {"pin": "2468"})
                found = browser.get(ROUTE).data
                assert (found["chosen"], found["in_use"], found["detectors"]) == ("x", "", [])
                assert found["problem"]["code"] == "detector_missing"
                assert browser.put(ROUTE, {"name": ""}).data["problem"] is None
        (tmp_path / "detectors" / "x.onnx").unlink(missing_ok=True)


def test_only_the_teacher_chooses(app: App, browser: Browser) -> None:
    pupil = Browser.signed_in(app.address)
    for answer in (
        pupil.get(ROUTE),
        pupil.put(ROUTE, {"name": ""}),
        add(pupil, "x.onnx", model().SerializeToString()),
        pupil.delete(f"{ROUTE}/x"),
    ):
        assert answer.error["code"] == "teacher_only"


@pytest.mark.parametrize("name", ["../pinel", "a/b", ".", "x" * 61])
def test_a_name_leads_to_no_other_folder(browser: Browser, name: str) -> None:
    assert browser.put(ROUTE, {"name": name}).status == 422
    assert browser.delete(f"{ROUTE}/{urllib.parse.quote(name, safe='')}").status in (404, 422)


def test_a_detector_learns_nothing(app: App, browser: Browser) -> None:
    add(browser, "x.onnx", model().SerializeToString())
    classroom = app._store.classrooms.create("5º B").id
    refused = browser.post(f"/api/classrooms/{classroom}/signs/Y/samples")
    assert refused.error["code"] == "detector_cannot_learn"


def test_the_recognizer_of_the_command_line_counts(tmp_path: Path, pictures: Path) -> None:
    detector = write_detector(tmp_path / "mine.onnx")
    name = f"yolo:{detector}"
    with App(tmp_path / "pinel.db", camera=str(pictures), recognizer=name) as app:
        browser = Browser.signed_in(app.address)
        browser.put("/api/teacher/pin", {"pin": "2468"})
        assert browser.get(ROUTE).data["of_command"] == name
        assert browser.put(ROUTE, {"name": ""}).error["code"] == "recognizer_of_command"
