"""The table of attacks, continued: what a disk does in the middle of a lesson. It reads as `test_attacks.py` does."""

import os
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest

from pinel_desktop.app import App
from pinel_desktop.desktop.app_process import AppProcess
from pinel_desktop.instance import AlreadyRunningError, InstanceLock
from pinel_desktop.school.teacher import TeacherSessions
from storage import open_store
from tests.attacks.damage import pinel
from tests.attacks.disks import (
    Served,
    fill,
    left_by_a_kill,
    make_read_only,
    second_start,
    served,
    small_disk,
)
from tests.attacks.engine import FAR
from tests.attacks.killed_exports import is_whole, killed_exports
from tests.attacks.pins import PIN
from tests.live_runs import command, saved, start_run
from tests.storage.bundle_makers import work
from tests.web.browser import Browser
from tests.web.fake_engine import FakeEngine

MakeDisk = Callable[[str], Path]


@pytest.fixture
def make_disk(tmp_path: Path) -> Iterator[MakeDisk]:
    with ExitStack() as stack:
        yield lambda kind: stack.enter_context(small_disk(tmp_path, kind))


def lesson(path: Path) -> Path:
    """A file with a group and the teacher's PIN."""
    with open_store(path) as store:
        store.groups.create("Onças")
        TeacherSessions(store.settings).set_pin(PIN)
    return path


# ---- a disk that is full ----


@pytest.mark.waits
@pytest.mark.parametrize("left_kb", [0, 4, 8, 12])
@pytest.mark.parametrize("kind", ["tmpfs", "ext4"])
def test_on_a_full_disk_the_app_starts_shows_the_work_and_lets_the_teacher_in(
    make_disk: MakeDisk, kind: str, left_kb: int
) -> None:
    path = lesson(make_disk(kind) / "pinel.db")
    fill(path.parent, left_kb)
    with served(path) as app:
        assert app.groups == ["Onças"]
        assert app.browser.post("/api/teacher/enter", {"pin": PIN}).status < 300
        assert "Traceback" not in app.output
        assert app.end() == 0
    assert not path.with_name("pinel.instance.json").exists()


@pytest.mark.waits
@pytest.mark.parametrize("kind", ["tmpfs", "ext4"])
def test_on_a_full_disk_the_work_of_an_app_that_was_killed_is_shown_too(
    make_disk: MakeDisk, kind: str
) -> None:
    path = make_disk(kind) / "pinel.db"
    left_by_a_kill(path)
    fill(path.parent, 0)
    with served(path) as app:
        assert app.groups == ["Onças"]
        assert app.end() == 0


@pytest.mark.waits
def test_on_a_full_disk_the_window_opens(make_disk: MakeDisk) -> None:
    path = lesson(make_disk("tmpfs") / "pinel.db")
    fill(path.parent, 0)
    lock = InstanceLock(path)
    lock.acquire()
    app = AppProcess(path, on_request=lambda request: None, on_lost=lambda: None)
    try:
        app.start()
        browser = Browser.signed_in(app.address())
        assert [one["name"] for one in browser.get("/api/groups").data["groups"]] == ["Onças"]
        app.language()
        assert app.failure is None
    finally:
        app.close()
        lock.release()


@pytest.mark.waits
def test_a_folder_in_the_place_of_the_address_keeps_no_app_from_starting_and_is_named(
    tmp_path: Path,
) -> None:
    path = lesson(tmp_path / "pinel.db")
    (tmp_path / "pinel.instance.json").mkdir()
    with served(path) as app:
        assert app.groups == ["Onças"]
        status, output = second_start(path)
        assert (status, "already open" in output, "pinel.instance.json" in output) == (
            1,
            True,
            True,
        )
        assert "Traceback" not in output
        assert app.end() == 0
        assert "Traceback" not in app.output


# ---- a disk that turns read-only ----


@pytest.mark.waits
def test_a_disk_that_turns_read_only_is_told_and_a_stopped_run_is_shown_as_stopped(
    make_disk: MakeDisk,
) -> None:
    path = make_disk("ext4") / "pinel.db"
    with served(path) as app:
        run = stopped_when_read_only(app)
        refusal = app.browser.post("/api/groups", {"name": "Tucanos"}).error["code"]
        assert refusal == app.database["notice"]["code"] == "database_read_only"
        assert app.browser.get(f"/api/runs/{run}").data["state"] == "stopped"
        group = app.browser.get("/api/groups").data["groups"][0]["id"]
        listed = app.browser.get(f"/api/groups/{group}/runs").data["runs"]
        assert [(one["id"], one["state"]) for one in listed] == [(run, "stopped")]
        assert app.end() == 0
        assert "Traceback" not in app.output


@pytest.mark.waits
def test_a_run_in_a_file_that_can_only_be_read_does_not_run_for_ever(make_disk: MakeDisk) -> None:
    path = make_disk("ext4") / "pinel.db"
    with served(path) as app:
        run = stopped_when_read_only(app)
        app.end()
    with served(path) as app:
        assert app.browser.get(f"/api/runs/{run}").data["reason"] == "interrupted"
        assert app.end() == 0


def stopped_when_read_only(app: Served) -> str:
    """A run that a person stops after its disk has turned read-only."""
    with app.browser.stream() as stream:
        stream.next()
        run = start_run(app.browser, saved(app.browser, FAR))
        stream.until("telemetry")
        make_read_only(app.path.parent)
        command(app.browser, run, "stop")
        assert stream.until("run_ended")[-1]["state"] == "stopped"
    return run


# ---- an export that is killed ----


@pytest.mark.waits
@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
def test_an_export_that_is_killed_at_any_step_leaves_no_file_that_is_not_complete(
    tmp_path: Path,
) -> None:
    with open_store(tmp_path / "pinel.db") as store:
        work(store, store.groups.create("Onças"), "Quadrado")
    stick = tmp_path / "stick"
    stick.mkdir()
    assert killed_exports(tmp_path / "pinel.db", stick, n_by_chance=20) >= 5
    bundles = list(stick.glob("*.pinel"))
    assert len(bundles) >= 2
    assert [one.name for one in bundles if not is_whole(one)] == []


# ---- something else that has the name of a small file ----

SMALL_FILES = [
    "pinel.db.mark.json",
    "pinel.db.copies.json",
    "pinel.db.page.json",
    "pinel.db.key",
    "pinel.instance.json",
]
MAKE: dict[str, Callable[[Path], None]] = {
    "a pipe": os.mkfifo if hasattr(os, "mkfifo") else Path.mkdir,
    "a folder": Path.mkdir,
    "a link to a device": lambda path: path.symlink_to("/dev/zero"),
}


@pytest.mark.waits
@pytest.mark.skipif(os.name != "posix", reason="no pipes with names")
@pytest.mark.parametrize("what", MAKE)
def test_no_small_file_that_is_something_else_holds_up_start_export_or_end(
    tmp_path: Path, what: str
) -> None:
    path = lesson(tmp_path / "pinel.db")
    for name in SMALL_FILES:
        (tmp_path / name).unlink(missing_ok=True)
        MAKE[what](tmp_path / name)
    with served(path) as app:
        assert app.groups == ["Onças"]
        app.browser.post("/api/groups", {"name": "Tucanos"})
        assert app.end() == 0
        assert "Traceback" not in app.output
    (tmp_path / "pinel.db-wal").unlink(missing_ok=True)
    MAKE[what](tmp_path / "pinel.db-wal")
    with served(path) as app:  # what SQLite cannot use is told
        assert app.database["notice"] or app.groups
        assert app.end() == 0
    assert pinel("--db", path, "export", tmp_path / "stick") in (0, 1)


@pytest.mark.waits
@pytest.mark.skipif(os.name != "posix", reason="Windows locks no folder")
@pytest.mark.parametrize("what", MAKE)
def test_no_second_app_opens_beside_the_first_whatever_the_lock_file_is(
    tmp_path: Path, what: str
) -> None:
    path = tmp_path / "pinel.db"
    MAKE[what](tmp_path / "pinel.lock")
    with App(path, make_engine=FakeEngine) as first:
        with pytest.raises(AlreadyRunningError) as second:
            App(path).start()
        assert Browser.at(second.value.running.url).port == Browser.at(first.address).port
    with App(path, make_engine=FakeEngine):  # the lock was given back
        pass
