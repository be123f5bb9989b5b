"""One lesson file prepares all PCs; presets with which the groups of a class start."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.app import App
from tests.web.browser import Browser
from tests.web.test_own_activities import DRAFT

PIN = "314159"


@pytest.fixture
def teacher(app: App) -> Browser:
    tab = Browser.signed_in(app.address)
    tab.put("/api/teacher/pin", {"pin": PIN})
    return tab


@pytest.fixture
def classroom(teacher: Browser) -> str:
    return str(teacher.post("/api/classrooms", {"name": "9º A"}).data["id"])


@pytest.fixture
def lesson(teacher: Browser, classroom: str) -> dict[str, Any]:
    """An open lesson with an own activity; the class has two groups, a preset and earlier work."""
    group = teacher.post("/api/groups", {"name": "Robôs", "classroom_id": classroom}).data["id"]
    teacher.post("/api/groups", {"name": "Tatus", "classroom_id": classroom})
    teacher.post(f"/api/groups/{group}/programs", {"name": "De ontem"})
    made = teacher.post("/api/own-activities", DRAFT).data["id"]
    preset = {"level": 2, "world": "maze", "swap_minutes": 10, "activity": made}
    teacher.put(f"/api/classrooms/{classroom}/preset", preset)
    new_lesson = {"title": "", "activity": made}
    opened: dict[str, Any] = teacher.post(f"/api/classrooms/{classroom}/lessons", new_lesson).data
    return opened


@pytest.fixture
def other(start_app: Callable[..., App], tmp_path: Path) -> Browser:
    """The page of another PC, which has an empty database and no PIN."""
    return Browser.signed_in(start_app(tmp_path / "other.db").address)


def sent(browser: Browser, octets: bytes) -> Any:
    kind = {"Content-Type": "application/octet-stream"}
    return browser.send("POST", "/api/lessons/file?name=aula.pinel", body=octets, headers=kind)


def test_another_pc_has_the_lesson_open_after_it_and_once_more_changes_nothing(
    teacher: Browser, lesson: dict[str, Any], other: Browser
) -> None:
    octets = teacher.get(f"/api/lessons/{lesson['id']}/file").body
    opened = sent(other, octets).data
    assert opened["lesson"]["title"] == "Até a linha"
    assert (opened["classroom"]["name"], opened["n_groups"]) == ("9º A", 2)
    assert not opened["nothing_new"]
    here = f"/api/classrooms/{opened['classroom']['id']}/lesson"
    now = other.get(here).data
    assert now["lesson"]["id"] == lesson["id"]
    assert now["preset"] == {
        "level": 2,
        "world": "maze",
        "swap_minutes": 10,
        "activity": lesson["activity"],
        "album": None,
    }
    groups = other.get("/api/groups").data["groups"]
    assert sorted((one["name"], one["n_programs"]) for one in groups) == [
        ("Robôs", 0),
        ("Tatus", 0),
    ]
    created = other.post(
        f"/api/groups/{groups[0]['id']}/activities", {"activity": lesson["activity"]}
    )
    assert created.data["name"] == "Até a linha"
    again = sent(other, octets).data
    assert again["nothing_new"]
    assert other.get(here).data["lesson"]["id"] == lesson["id"]


def test_a_pc_with_a_pin_opens_it_for_the_teacher_only(
    browser: Browser, teacher: Browser, lesson: dict[str, Any], tmp_path: Path
) -> None:
    octets = teacher.get(f"/api/lessons/{lesson['id']}/file").body
    assert sent(browser, octets).error["code"] == "teacher_only"
    assert browser.get(f"/api/lessons/{lesson['id']}/file").error["code"] == "teacher_only"
    path = {"path": str(tmp_path)}
    assert browser.post("/api/lessons/file/path", path).error["code"] == "teacher_only"


def test_a_file_in_the_shared_folder_is_known_as_a_lesson_and_opened(
    teacher: Browser, lesson: dict[str, Any], tmp_path: Path
) -> None:
    folder = tmp_path / "school"
    folder.mkdir()
    teacher.put("/api/folders/shared", {"path": str(folder)})
    here = f"/api/lessons/{lesson['id']}/file"
    written = teacher.post(here, {"folder": str(folder)}).data
    teacher.post("/api/bundles", {"folder": str(folder)})
    (found,) = teacher.get("/api/folders").data["folders"]
    assert {one["name"] for one in found["files"] if one["lesson"]} == {written["name"]}
    assert len(found["files"]) == 2
    teacher.patch(f"/api/lessons/{lesson['id']}", {"closed": True})
    assert teacher.post("/api/lessons/file/path", {"path": written["path"]}).status == 200
    now = teacher.get(f"/api/classrooms/{lesson['classroom_id']}/lesson").data
    assert now["lesson"]["id"] == lesson["id"]
    missing = teacher.post(here, {"folder": str(folder / "x")})
    assert missing.error["code"] == "folder_missing"


def test_files_of_another_kind_are_refused(
    teacher: Browser, lesson: dict[str, Any], other: Browser, tmp_path: Path
) -> None:
    bundle = teacher.post("/api/bundles", {"folder": str(tmp_path)}).data
    assert sent(other, Path(bundle["path"]).read_bytes()).error["code"] == "bundle_not_lesson"
    assert sent(other, b"nothing").error["code"] == "bundle_foreign"
    assert other.get("/api/groups").data["groups"] == []


def test_a_new_program_begins_in_the_world_that_is_set_for_the_class(
    teacher: Browser, classroom: str
) -> None:
    made = teacher.post("/api/own-activities", {**DRAFT, "world": "neighbourhood"}).data["id"]
    group = teacher.post("/api/groups", {"name": "G", "classroom_id": classroom}).data["id"]

    def version() -> Any:
        program = teacher.post(f"/api/groups/{group}/programs", {"name": "P"}).data["id"]
        return teacher.get(f"/api/programs/{program}").data["version"]

    assert version() is None
    here = f"/api/classrooms/{classroom}/preset"
    teacher.put(here, {"world": "maze"})
    assert version()["setup"]["world"] == "maze"
    teacher.put(here, {"world": made})
    of_activity = version()
    assert of_activity["setup"]["world"] == of_activity["world"]["name"] == "own"
    assert {zone["name"] for zone in of_activity["world"]["zones"]} >= {"casa", "escola"}


@pytest.mark.parametrize(
    ("preset", "code"),
    [
        ({"world": "x"}, "unknown_world"),
        ({"activity": "x"}, "unknown_activity"),
        ({"level": 4}, "invalid_request"),
        ({"swap_minutes": 7}, "invalid_request"),
    ],
)
def test_a_preset_names_what_there_is(
    browser: Browser, teacher: Browser, classroom: str, preset: dict[str, Any], code: str
) -> None:
    here = f"/api/classrooms/{classroom}/preset"
    assert teacher.put(here, preset).error["code"] == code
    assert browser.put(here, {}).error["code"] == "teacher_only"
