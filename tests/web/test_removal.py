"""Permanent deletion: from the database and its backups, and merging a bundle does not restore it."""

from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.app import App
from storage.file.backups import list_backups, make_backup
from tests.storage.sample_runs import ended
from tests.web.browser import Browser
from tests.web.fake_engine import FakeEngine


@pytest.fixture
def teacher(browser: Browser) -> Browser:
    browser.put("/api/teacher/pin", {"pin": "314159"})
    return browser


def test_a_deleted_group_is_nowhere_and_does_not_come_back(
    app: App,
    teacher: Browser,
    engine: FakeEngine,
    group: dict[str, Any],
    run: dict[str, Any],
    tmp_path: Path,
) -> None:
    engine.send(ended(run["id"], 0, 0))
    app._flush_recording()
    store = app._store
    make_backup(store.path, store._database._clock())
    bundle = teacher.post("/api/bundles", {"folder": str(tmp_path)}).data
    removed = teacher.delete(f"/api/groups/{group['id']}").data
    assert (removed["n_groups"], removed["n_programs"], removed["n_runs"]) == (1, 1, 1)
    assert [file["path"] for file in removed["files"]] == [bundle["path"]]
    assert removed["backups"] == []
    assert teacher.get("/api/groups").data["groups"] == []
    name = group["name"].encode()
    (backup,) = list_backups(store.path)
    assert name in Path(bundle["path"]).read_bytes()
    assert name not in backup.path.read_bytes()
    assert name not in store.path.read_bytes()
    merged = teacher.post("/api/bundles/merge", {"paths": [bundle["path"]]}).data["merged"]
    assert merged[0]["problem"] is None
    assert teacher.get("/api/groups").data["groups"] == []


def test_a_class_goes_with_its_groups(teacher: Browser) -> None:
    classroom = teacher.post("/api/classrooms", {"name": "9º A"}).data["id"]
    for name in ("A", "B"):
        teacher.post("/api/groups", {"name": name, "classroom_id": classroom})
    assert teacher.delete(f"/api/classrooms/{classroom}").data["n_groups"] == 2
    assert teacher.get("/api/classrooms").data["classrooms"] == []


def test_only_the_teacher_deletes_and_not_in_the_middle_of_a_run(
    browser: Browser, group: dict[str, Any], run: dict[str, Any]
) -> None:
    place = f"/api/groups/{group['id']}"
    assert browser.delete(place).error["code"] == "pin_missing"
    browser.put("/api/teacher/pin", {"pin": "314159"})
    refused = browser.delete(place)
    assert (refused.status, refused.error["code"]) == (409, "run_in_progress")
    assert browser.delete("/api/groups/x").error["code"] == "group_not_found"
