"""Transfer of work between PCs: removable drives, the shared folder, a program as a file."""

import json
import tempfile
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import Any
from urllib.parse import quote

import pytest

from pinel_desktop.app import App
from storage.exchange.scope import Scope
from storage.file.backups import make_backup
from storage.sql import opened
from tests.storage.sample_runs import ended
from tests.web.browser import ApiResponse, Browser
from tests.web.conftest import SQUARE
from tests.web.fake_engine import FakeEngine

PIN = {"pin": "314159"}


@pytest.fixture
def stick(tmp_path: Path) -> Path:
    folder = tmp_path / "pen drive é"
    folder.mkdir()
    return folder


@pytest.fixture
def other(start_app: Callable[..., App], tmp_path: Path) -> Browser:
    """The teacher at another PC."""
    browser = Browser.signed_in(start_app(tmp_path / "other" / "pinel.db").address)
    browser.put("/api/teacher/pin", PIN)
    return browser


@pytest.fixture
def teacher(browser: Browser) -> Browser:
    browser.put("/api/teacher/pin", PIN)
    return browser


def test_all_work_goes_to_another_pc_by_stick(
    teacher: Browser, other: Browser, version: dict[str, Any], stick: Path
) -> None:
    teacher.patch("/api/computer", {"name": "PC 07"})
    written = teacher.post("/api/bundles", {"folder": str(stick)}).data
    assert written["name"].startswith("PC 07-")
    assert (written["n_groups"], written["n_programs"], written["n_runs"]) == (1, 1, 0)
    assert written["left_out"] is None
    other.put("/api/folders/shared", {"path": str(stick)})
    (folder,) = other.get("/api/folders").data["folders"]
    assert [(file["name"], file["own"]) for file in folder["files"]] == [(written["name"], False)]
    to_merge = {"paths": [folder["files"][0]["path"]]}
    first, again = (other.post("/api/bundles/merge", to_merge).data for _ in range(2))
    assert first["merged"][0]["added"] == {"groups": 1, "programs": 1, "versions": 1, "runs": 0}
    assert (first["merged"][0]["computer"], again["merged"][0]["nothing_new"]) == ("PC 07", True)
    assert first["content_hash"] == again["content_hash"]
    (lesson,) = other.get("/api/classrooms/none/lessons").data["lessons"]
    assert [one["merged"][0]["lesson"]["id"] for one in (first, again)] == [lesson["id"]] * 2
    (computer,) = other.get("/api/bundles/heard").data["computers"]
    assert computer["name"] == "PC 07"
    assert [group["name"] for group in other.get("/api/groups").data["groups"]] == ["Os Robôs"]


def test_a_file_of_this_pc_is_marked_as_its_own(
    teacher: Browser, other: Browser, version: dict[str, Any], stick: Path
) -> None:
    teacher.patch("/api/computer", {"name": "PC 07"})
    teacher.post("/api/bundles", {"folder": str(stick)})
    other.patch("/api/computer", {"name": "PC 08"})
    other.post("/api/bundles", {"folder": str(stick)})
    (folder,) = teacher.put("/api/folders/shared", {"path": str(stick)}).data["folders"]
    assert {file["name"][:5]: file["own"] for file in folder["files"]} == {
        "PC 07": True,
        "PC 08": False,
    }


def test_a_run_names_the_other_pc_on_which_it_ran(
    teacher: Browser, other: Browser, engine: FakeEngine, run: dict[str, Any], stick: Path
) -> None:
    teacher.patch("/api/computer", {"name": "PC 07"})
    engine.send(ended(run["id"], 0, 0))
    path = teacher.post("/api/bundles", {"folder": str(stick)}).data["path"]
    other.post("/api/bundles/merge", {"paths": [path]})
    names = [one.get(f"/api/runs/{run['id']}").data["other_computer"] for one in (teacher, other)]
    assert names == [None, "PC 07"]


def test_the_file_with_which_the_app_was_opened_is_offered_to_the_teacher_until_it_is_merged(
    teacher: Browser,
    start_app: Callable[..., App],
    version: dict[str, Any],
    stick: Path,
    tmp_path: Path,
) -> None:
    file = teacher.post("/api/bundles", {"folder": str(stick)}).data["path"]
    opened = Browser.signed_in(start_app(tmp_path / "other" / "pinel.db", opened=file).address)
    assert opened.get("/api/folders").error["code"] == "pin_missing"
    opened.put("/api/teacher/pin", PIN)
    offer = opened.get("/api/folders").data["opened"]
    assert (offer["file"]["path"], offer["problem"]) == (file, None)
    assert opened.get("/api/groups").data["groups"] == []
    opened.post("/api/bundles/merge", {"paths": [file]})
    assert opened.get("/api/folders").data["opened"] is None
    assert len(opened.get("/api/groups").data["groups"]) == 1


def test_an_opened_file_that_is_no_bundle_is_refused_by_its_name(
    start_app: Callable[..., App], stick: Path
) -> None:
    file = stick / "foto.pinel"
    file.write_text("no database", "utf-8")
    opened = Browser.signed_in(start_app(opened=str(file)).address)
    opened.put("/api/teacher/pin", PIN)
    offer = opened.get("/api/folders").data["opened"]
    assert (offer["file"], offer["problem"]["code"]) == (None, "bundle_foreign")
    assert offer["problem"]["message"] == "The file foto.pinel was not exported by PINEL."


def test_what_other_pcs_would_refuse_is_said(
    app: App, teacher: Browser, version: dict[str, Any], stick: Path
) -> None:
    late = "UPDATE groups SET changed_at = '9999-12-31T00:00:00Z'"
    app._store._database.write(lambda db: db.execute(late))
    written = teacher.post("/api/bundles", {"folder": str(stick)}).data
    assert written["n_groups"] == 0
    assert written["left_out"]["code"] == "export_left_out"
    assert "left out of the file" in written["left_out"]["message"]
    assert "Os Robôs / " in written["left_out"]["message"]


def test_a_group_hears_what_its_file_lacks(
    app: App, browser: Browser, program: dict[str, Any], version: dict[str, Any]
) -> None:
    place = f"/api/programs/{program['id']}"
    whole = browser.get(f"{place}/file")
    assert "Pinel-Left-Out" not in whole.headers
    browser.post(f"{place}/versions", {"workspace": {"more": 1}, "document": SQUARE})
    # damages the value without updating its checksum, as a disk does
    with closing(opened(app._store.path, "rw")) as disk:
        disk.execute("UPDATE versions SET workspace = '{}' WHERE number = 2")
    lacks = json.loads(browser.get(f"{place}/file").headers["Pinel-Left-Out"])
    assert lacks["code"] == "program_file_left_out"
    assert lacks["message"].endswith(": 1.")
    assert "Tell the teacher" in lacks["remedy"]


def test_work_can_be_shown_to_others_without_names(
    teacher: Browser, other: Browser, version: dict[str, Any], stick: Path
) -> None:
    options = {"folder": str(stick), "anonymous": True}
    written = teacher.post("/api/bundles", options).data
    assert written["name"].startswith("PINEL-no-names-")
    assert "Os Robôs".encode() not in Path(written["path"]).read_bytes()
    (merged,) = other.post("/api/bundles/merge", {"paths": [written["path"]]}).data["merged"]
    assert merged["anonymous"]
    (group,) = other.get("/api/groups").data["groups"]
    assert group["name"] != "Os Robôs"


def test_a_file_without_names_is_told_from_others_whatever_it_is_called(
    teacher: Browser, version: dict[str, Any], stick: Path
) -> None:
    teacher.post("/api/bundles", {"folder": str(stick)})
    written = teacher.post("/api/bundles", {"folder": str(stick), "anonymous": True}).data
    Path(written["path"]).rename(stick / "a.pinel")
    (stick / "b.pinel").write_bytes((stick / "a.pinel").read_bytes()[:5000])
    (stick / "c.pinel").write_text("a letter", "utf-8")
    (stick / "d.pinel").touch()
    (folder,) = teacher.put("/api/folders/shared", {"path": str(stick)}).data["folders"]
    assert len(folder["files"]) == 5
    nameless = {file["name"] for file in folder["files"] if file["anonymous"]}
    assert "a.pinel" in nameless
    assert nameless <= {"a.pinel", "b.pinel"}


def test_what_was_deleted_for_good_is_told_when_an_old_file_holds_it(
    teacher: Browser, other: Browser, version: dict[str, Any], stick: Path
) -> None:
    old = {"paths": [teacher.post("/api/bundles", {"folder": str(stick)}).data["path"]]}
    other.post("/api/bundles/merge", old)
    for browser in (teacher, other):
        browser.send("DELETE", f"/api/groups/{_group(browser)}")
        for _ in range(2):
            (merged,) = browser.post("/api/bundles/merge", old).data["merged"]
            assert merged["nothing_new"]
            assert merged["held_back"] == {"groups": 1, "programs": 1, "versions": 1, "runs": 0}
    assert teacher.get("/api/groups").data == {"groups": []}


def test_what_goes_as_it_was_deleted_elsewhere_is_counted(
    teacher: Browser, other: Browser, version: dict[str, Any], stick: Path
) -> None:
    def bundle() -> dict[str, Any]:
        return {"paths": [teacher.post("/api/bundles", {"folder": str(stick)}).data["path"]]}

    (merged,) = other.post("/api/bundles/merge", bundle()).data["merged"]
    assert (merged["held_back"], merged["removed"]) == (None, None)
    teacher.send("DELETE", f"/api/groups/{_group(teacher)}")
    newer = bundle()
    (merged,) = other.post("/api/bundles/merge", newer).data["merged"]
    assert merged["would_delete"]["groups"] == 1
    assert (merged["nothing_new"], merged["removed"]) == (True, None)
    (merged,) = other.post("/api/bundles/merge", {**newer, "delete": True}).data["merged"]
    assert merged["removed"] == {"groups": 1, "programs": 1, "versions": 1, "runs": 0}


def test_a_deletion_that_nobody_decided_about_is_listed_until_it_is_confirmed_or_kept(
    teacher: Browser, other: Browser, version: dict[str, Any], stick: Path
) -> None:
    def bundle() -> dict[str, Any]:
        return {"paths": [teacher.post("/api/bundles", {"folder": str(stick)}).data["path"]]}

    def waiting() -> Any:
        return other.get("/api/bundles/heard").data["undecided"]

    earlier = bundle()
    other.post("/api/bundles/merge", earlier)
    group = _group(teacher)
    teacher.send("DELETE", f"/api/groups/{group}")
    newer = bundle()
    other.post("/api/bundles/merge", newer)
    other.post("/api/bundles/merge", earlier)
    (one,) = waiting()
    assert (one["path"], one["name"]) == (newer["paths"][0], Path(newer["paths"][0]).name)
    assert (one["groups"], one["programs"], one["runs"]) == (1, 1, 0)
    (again,) = other.post("/api/bundles/merge", {"paths": [one["path"]]}).data["merged"]
    assert again["would_delete"]["groups"] == 1
    assert waiting() == [one]
    other.post("/api/bundles/merge", {**newer, "delete": True, "kept": [group]})
    assert waiting() == []


def test_a_file_that_is_refused_does_not_keep_the_others_out(
    teacher: Browser, other: Browser, version: dict[str, Any], stick: Path
) -> None:
    good = teacher.post("/api/bundles", {"folder": str(stick)}).data["path"]
    bad = stick / "bad.pinel"
    bad.write_bytes(Path(good).read_bytes()[:5000])
    paths = [str(bad), good, str(stick / "gone.pinel"), str(stick)]
    merged = other.post("/api/bundles/merge", {"paths": paths}).data["merged"]
    assert [one["problem"] is None for one in merged] == [False, True, False, False]
    for one in merged:
        if one["problem"]:
            assert one["problem"]["message"] != one["problem"]["code"]
            assert one["name"] in one["problem"]["message"]
            assert one["path"] not in one["problem"]["message"]
            assert one["problem"]["remedy"]


def test_a_group_goes_on_with_its_program_at_another_pc(
    browser: Browser, other: Browser, program: dict[str, Any], version: dict[str, Any]
) -> None:
    octets = browser.get(f"/api/programs/{program['id']}/file").body
    brought = _bring(other, octets).data
    assert brought == {
        "program_id": program["id"],
        "group_id": program["group_id"],
        "classroom_id": None,
        "nothing_new": False,
    }
    place = f"/api/programs/{program['id']}"
    assert other.get(place).data["version"]["document"]["name"] == "square"
    more = {"workspace": {"more": 1}, "document": SQUARE}
    assert other.post(f"{place}/versions", more).status == 200
    back = other.get(f"{place}/file").body
    assert _bring(browser, back).data["nothing_new"] is False
    assert _bring(browser, back).data["nothing_new"] is True
    assert browser.get(place).data["version"]["workspace"] == {"more": 1}
    assert browser.get(f"{place}/versions").data["versions"][0]["number"] == 2


def test_pupils_bring_in_one_program_only(
    app: App, browser: Browser, version: dict[str, Any], tmp_path: Path
) -> None:
    browser.post("/api/groups", {"name": "B"})
    browser.post(f"/api/groups/{_group(browser)}/programs", {"name": "Segundo"})
    store = app._store
    info = store.exchange.export(
        tmp_path / "all.pinel", app_version="1", computer=store.computers.this(), scope=Scope()
    )
    refused = _bring(browser, info.path.read_bytes())
    assert (refused.status, refused.error["code"]) == (422, "bundle_not_program")
    rubbish = _bring(browser, b"rubbish")
    assert rubbish.status == 422
    assert "foto da turma.pinel" in rubbish.error["message"]
    assert rubbish.error["remedy"]
    assert tempfile.gettempdir() not in _bring(browser, b"", "").error["message"]


def test_sticks_and_files_are_the_teacher_s(browser: Browser, stick: Path) -> None:
    for answer in (
        browser.get("/api/folders"),
        browser.put("/api/folders/shared", {"path": str(stick)}),
        browser.post("/api/bundles", {"folder": str(stick)}),
        browser.post("/api/bundles/merge", {"paths": ["a"]}),
        browser.get("/api/bundles/heard"),
    ):
        assert (answer.status, answer.error["code"]) == (403, "pin_missing")


def test_a_folder_that_is_not_there_is_said(teacher: Browser, stick: Path) -> None:
    missing = str(stick / "gone")
    for answer in (
        teacher.put("/api/folders/shared", {"path": missing}),
        teacher.post("/api/bundles", {"folder": missing}),
    ):
        assert answer.error["code"] == "folder_missing"
        assert missing in answer.error["message"]


def test_a_shared_folder_that_does_not_answer_stays_chosen(teacher: Browser, stick: Path) -> None:
    folder = stick / "rede"
    folder.mkdir()
    teacher.put("/api/folders/shared", {"path": str(folder)})
    folder.rmdir()
    places = teacher.get("/api/folders").data
    assert places["shared"] == str(folder)
    (folder_info,) = places["folders"]
    assert (folder_info["name"], folder_info["is_reachable"], folder_info["is_writable"]) == (
        "rede",
        False,
        False,
    )
    none: dict[str, Any] = {"folders": [], "opened": None, "shared": "", "takes_backups": False}
    assert teacher.put("/api/folders/shared", {"path": ""}).data == none


def test_the_shared_folder_takes_copies_of_the_backups_when_that_is_ticked(
    app: App, teacher: Browser, stick: Path
) -> None:
    store = app._store
    make_backup(store.path, store._database._clock())
    for body, is_ticked in (({}, False), ({"takes_backups": True}, True), ({}, True)):
        put = teacher.put("/api/folders/shared", {"path": str(stick)} | body)
        assert put.data["takes_backups"] is is_ticked
    assert store.backup_share.update(20)
    assert len(list(stick.glob("PINEL-backups/*/*.db"))) == 1
    stick.rename(stick.with_name("away"))
    end = {"path": str(stick), "takes_backups": False}
    assert teacher.put("/api/folders/shared", end).data["takes_backups"] is False


FILE = {"Content-Type": "application/octet-stream"}


def _bring(browser: Browser, octets: bytes, name: str = "foto da turma.pinel") -> ApiResponse:
    address = f"/api/programs/file?name={quote(name)}"
    return browser.send("POST", address, body=octets, headers=FILE)


def _group(browser: Browser) -> str:
    return str(browser.get("/api/groups").data["groups"][0]["id"])


@pytest.mark.parametrize("folder", ["", "x" * 300, "a\0b", "\ud800"])
def test_what_can_be_no_folder_is_refused_in_words(teacher: Browser, folder: str) -> None:
    answers = [teacher.post("/api/bundles", {"folder": folder})]
    if folder:
        answers.append(teacher.put("/api/folders/shared", {"path": folder}))
    assert [answer.status for answer in answers] == [422] * len(answers)
