"""Kiosk mode over HTTP: who may change and leave it, and the files on drives."""

import queue
import threading
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal
from urllib.parse import quote

import pytest

from pinel_desktop.app import App
from pinel_desktop.web import page
from pinel_desktop.web.services import WindowRequest
from tests.web.browser import ApiResponse, Browser

PIN = {"pin": "314159"}
WITHIN_S = 10


@dataclass
class RecordedWindow:
    """A window that records what the app asks of it."""

    kiosk: Literal["setting", "command"] | None = None
    asked: "queue.Queue[WindowRequest]" = field(default_factory=queue.Queue)

    def ask(self, request: WindowRequest) -> None:
        self.asked.put(request)

    def present(self, address: str | None) -> bool:
        return False

    def next_request(self) -> WindowRequest:
        """Waits for a request, which may follow the answer to the page."""
        return self.asked.get(timeout=WITHIN_S)


@dataclass
class ClosingWindow(RecordedWindow):
    """A window that closes the app unless the page gets its answer first."""

    answered: threading.Event = field(default_factory=threading.Event)
    closed_early: bool = False

    def ask(self, request: WindowRequest) -> None:
        self.closed_early = not self.answered.wait(WITHIN_S)
        super().ask(request)


@pytest.fixture
def window() -> RecordedWindow:
    return RecordedWindow(kiosk="setting")


@pytest.fixture
def pupil(start_app: Callable[..., App], window: RecordedWindow) -> Browser:
    app = start_app(window=window)
    app._settings.choose("pinel_kiosk", "1" if window.kiosk == "setting" else "")
    tab = Browser.signed_in(app.address)
    tab.put("/api/teacher/pin", PIN)
    return Browser.signed_in(app.address)


@pytest.fixture
def teacher(pupil: Browser) -> Browser:
    pupil.post("/api/teacher/enter", PIN)
    return pupil


@pytest.fixture
def stick(pupil: Browser, tmp_path: Path) -> Path:
    """A folder that the teacher has chosen as the shared folder, which is listed as a stick is."""
    folder = tmp_path / "PINEL ção"
    folder.mkdir()
    pupil.post("/api/teacher/enter", PIN)
    pupil.put("/api/folders/shared", {"path": str(folder)})
    pupil.post("/api/teacher/leave", {})
    return folder


@pytest.mark.parametrize("action", ["leave", "print"])
def test_only_the_teacher_leaves_or_prints(
    pupil: Browser, window: RecordedWindow, action: str
) -> None:
    assert pupil.post(f"/api/kiosk/{action}", {}).error["code"] == "teacher_only"
    assert pupil.put("/api/kiosk", {"is_chosen": False}).error["code"] == "teacher_only"
    assert window.asked.empty()
    pupil.post("/api/teacher/enter", PIN)
    assert pupil.post(f"/api/kiosk/{action}", {}).status == 200
    assert window.next_request() == {"leave": "close", "print": "allow_print"}[action]


def test_the_switch_opens_the_window_again_in_the_other_mode(
    teacher: Browser, window: RecordedWindow
) -> None:
    assert teacher.get("/api/kiosk").data["is_chosen"] is True
    assert teacher.put("/api/kiosk", {"is_chosen": True}).data["is_active"] is True
    assert window.asked.empty()
    assert teacher.put("/api/kiosk", {"is_chosen": False}).data["is_chosen"] is False
    assert window.next_request() == "restart"


@pytest.mark.parametrize(
    ("method", "path", "body", "request_"),
    [
        ("POST", "/api/kiosk/leave", {}, "close"),
        ("PUT", "/api/kiosk", {"is_chosen": False}, "restart"),
    ],
)
def test_the_page_has_its_answer_before_the_app_closes(
    start_app: Callable[..., App], method: str, path: str, body: object, request_: WindowRequest
) -> None:
    window = ClosingWindow(kiosk="setting")
    tab = Browser.signed_in(start_app(window=window).address)
    tab.put("/api/teacher/pin", PIN)
    answer = tab.send(method, path, body)
    window.answered.set()
    assert answer.status == 200
    assert window.next_request() == request_
    assert not window.closed_early


def test_the_page_knows_the_mode(
    pupil: Browser, tmp_path: Path, start_app: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    static = tmp_path / "static"
    static.mkdir()
    for name in ("index.html", "index.en.html"):
        (static / name).write_text("<html lang='en'></html>", "utf-8")
    monkeypatch.setattr(page, "STATIC", static)
    assert 'data-kiosk="1"' in pupil.get("/").text
    ordinary = start_app(tmp_path / "other.db", window=RecordedWindow())
    answer = Browser.signed_in(ordinary.address).get("/")
    assert answer.status == 200
    assert "data-kiosk" not in answer.text


def test_what_the_system_decides_is_not_changed_by_the_switch(
    start_app: Callable[..., App], tmp_path: Path
) -> None:
    window = RecordedWindow(kiosk="command")
    tab = Browser.signed_in(start_app(tmp_path / "other.db", window=window).address)
    tab.put("/api/teacher/pin", PIN)
    state = tab.put("/api/kiosk", {"is_chosen": False}).data
    assert (state["is_active"], state["is_by_command"]) == (True, True)
    assert window.asked.empty()


def test_a_browser_has_no_kiosk_mode(start_app: Callable[..., App], tmp_path: Path) -> None:
    tab = Browser.signed_in(start_app(tmp_path / "other.db").address)
    tab.put("/api/teacher/pin", PIN)
    state = tab.put("/api/kiosk", {"is_chosen": True}).data
    assert state == {
        "is_active": False,
        "is_chosen": True,
        "is_by_command": False,
        "has_window": False,
    }
    for path in ("leave", "print"):
        assert tab.post(f"/api/kiosk/{path}", {}).error["code"] == "kiosk_not_active"
    assert tab.get("/api/drives?suffix=.pinel").error["code"] == "kiosk_not_active"


def save(browser: Browser, drive: Path, name: str, content: bytes = b"{}") -> ApiResponse:
    address = f"/api/drives/file?drive={quote(str(drive))}&name={quote(name)}"
    kind = {"Content-Type": "application/octet-stream"}
    return browser.send("POST", address, body=content, headers=kind)


def read(browser: Browser, path: Path, suffix: str = ".json") -> ApiResponse:
    return browser.get(f"/api/drives/file?path={quote(str(path))}&suffix={suffix}")


def test_a_saved_file_is_found_and_read_again(pupil: Browser, stick: Path) -> None:
    content = bytes(range(256)) * 20_000
    assert save(pupil, stick, "meu mundo.json", content).data["name"] == "meu mundo.json"
    second = save(pupil, stick, "meu mundo.json").data["name"]
    assert second != "meu mundo.json"
    (drive,) = [
        one
        for one in pupil.get("/api/drives?suffix=.json").data["drives"]
        if one["path"] == str(stick)
    ]
    assert {file["name"] for file in drive["files"]} == {"meu mundo.json", second}
    assert read(pupil, stick / "meu mundo.json").body == content


@pytest.mark.parametrize("ending", ["pinel", "json", "py", "csv", "png", "gif", "html"])
def test_each_kind_of_file_that_the_page_makes_is_saved(
    pupil: Browser, stick: Path, ending: str
) -> None:
    assert save(pupil, stick, f"Onças Quadrado.{ending}").status == 200


def test_no_other_file_of_the_pc_can_be_read(pupil: Browser, stick: Path, tmp_path: Path) -> None:
    secret = tmp_path / "secret.json"
    secret.write_text("{}", "utf-8")
    (stick / "notes.txt").write_text("not for PINEL", "utf-8")
    (stick / "folder.json").mkdir()
    for path in (secret, stick / "../secret.json", stick / "notes.txt", stick / "folder.json"):
        assert read(pupil, path).error["code"] == "drive_file_missing", path
    assert read(pupil, stick / "notes.txt", ".txt").error["code"] == "invalid_request"


@pytest.mark.parametrize(
    "name",
    [
        "../a.json",
        "a/b.json",
        ".bashrc",
        "a.desktop",
        "a.sh",
        "a\n.json",
        ".json",
        "a" * 130 + ".json",
    ],
)
def test_only_plain_names_of_known_types_are_written(
    pupil: Browser, stick: Path, name: str
) -> None:
    assert save(pupil, stick, name).error["code"] == "invalid_request"
    assert list(stick.iterdir()) == []


def test_a_folder_that_is_no_drive_is_refused(pupil: Browser, stick: Path, tmp_path: Path) -> None:
    assert save(pupil, tmp_path, "a.json").error["code"] == "folder_missing"
    assert not (tmp_path / "a.json").exists()


def test_a_stick_that_cannot_be_written_is_named(
    pupil: Browser, stick: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("storage.file.atomic_files._sync", full)
    refused = save(pupil, stick, "a.json")
    assert refused.error["code"] == "export_failed"
    assert str(stick) in refused.error["message"]
    assert list(stick.iterdir()) == []
