"""Files into which an earlier release let made-up ids, numbers and revisions: mended at the start, nothing lost."""

from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path

import pytest

from storage import Store, StoreError, text
from storage.file.backups import list_backups
from storage.file.made_up import mended_id
from storage.sqlite import sqlite3
from storage.text import FIRST_MADE_UP_ID, new_id
from tests.attacks.made_up_files import FAR_ID, suffering
from tests.storage.bundle_makers import exported, hash_of, merged, problems_in, work

Opened = Callable[..., Store]


@pytest.fixture(autouse=True)
def ids_of_a_start(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """What a test makes ids follow is forgotten after it."""
    monkeypatch.setattr(text, "_ids", text._Ids())
    yield
    monkeypatch.undo()


def restarted(monkeypatch: pytest.MonkeyPatch, opened: Opened, path: Path) -> Store:
    monkeypatch.setattr(text, "_ids", text._Ids())
    return opened(path)


def test_ids_of_the_order_before_and_others_as_they_are() -> None:
    ids = [FAR_ID, "06000000-0000-7000-8000-000000000000", "06000000-0001-7000-8000-000000000000"]
    mended = [mended_id(key) for key in ids]
    assert mended == sorted(mended)
    assert all("01a1" <= key < "01a2" for key in mended)
    for key in (new_id(), "f6ffffff-ffff-5fff-bfff-ffffffffffff", "group", *mended):
        assert mended_id(key) == key


def test_all_work_of_a_pc_that_suffers_goes_to_others_after_the_next_start(
    path: Path, tmp_path: Path, opened: Opened, monkeypatch: pytest.MonkeyPatch
) -> None:
    with opened(path) as before:
        program_id = suffering(before)
        assert before.runs.newest(1)[0].id > FAR_ID
        assert exported(before, tmp_path / "before.pinel").left_out == ()
    here = restarted(monkeypatch, opened, path)
    assert here.notice is not None
    assert here.notice.code == "database_mended"
    assert len(list_backups(path)) == 1
    info = exported(here, tmp_path / "after.pinel")
    assert info.left_out == ()
    there = opened(tmp_path / "there.db")
    merged(there, info.path)
    assert hash_of(there) == hash_of(here)
    assert {group.name for group in there.groups.all()} == {"Araras", "Tucanos"}
    newest = there.versions.newest(program_id)
    assert newest is not None
    assert (newest.workspace, newest.number) == ({"mine": 1}, 4)
    assert (info.counts["versions"], info.counts["runs"], info.counts["notes"]) == (6, 3, 2)
    here.close()
    assert problems_in(path) == []


def test_a_file_is_mended_once(path: Path, opened: Opened, monkeypatch: pytest.MonkeyPatch) -> None:
    with opened(path) as before:
        suffering(before)
    restarted(monkeypatch, opened, path).close()
    again = restarted(monkeypatch, opened, path)
    assert (again.notice, len(list_backups(path))) == (None, 1)
    assert new_id() < FIRST_MADE_UP_ID


def test_two_pcs_that_suffer_from_the_same_rows_are_equal_afterwards(
    path: Path, tmp_path: Path, opened: Opened, monkeypatch: pytest.MonkeyPatch
) -> None:
    with opened(path) as before:
        suffering(before)
    copy = tmp_path / "copy.db"
    copy.write_bytes(path.read_bytes())
    here, there = (restarted(monkeypatch, opened, file) for file in (path, copy))
    assert hash_of(here) == hash_of(there)
    assert merged(here, exported(there, tmp_path / "t.pinel").path).added == {}


def test_without_a_backup_nothing_is_mended_and_new_work_still_travels(
    path: Path, tmp_path: Path, opened: Opened, monkeypatch: pytest.MonkeyPatch
) -> None:
    def no_room(*_: object, **__: object) -> None:
        raise StoreError("backup_no_room", folder="x")

    with opened(path) as before:
        suffering(before)
    monkeypatch.setattr("storage.file.backups.make_backup", no_room)
    here = restarted(monkeypatch, opened, path)
    assert here.notice is not None
    assert here.notice.code == "backup_no_room"
    work(here, here.groups.create("Novos"), "P")
    there = opened(tmp_path / "there.db")
    merged(there, exported(here, tmp_path / "x.pinel").path)
    assert "Novos" in {group.name for group in there.groups.all()}


def test_a_made_up_revision_no_longer_beats_a_correction(
    path: Path, tmp_path: Path, opened: Opened, monkeypatch: pytest.MonkeyPatch
) -> None:
    with opened(path) as before:
        group = before.groups.create("Feio")
    with closing(sqlite3.connect(path)) as db, db:
        db.execute("UPDATE groups SET revision = 1000000000, changed_at = '9998-01-01T00:00:00Z'")
    here = restarted(monkeypatch, opened, path)
    there = opened(tmp_path / "there.db")
    merged(there, exported(here, tmp_path / "a.pinel").path)
    here.groups.change(group.id, {"name": "Onças"})
    merged(there, exported(here, tmp_path / "b.pinel").path)
    assert there.groups.get(group.id).name == "Onças"
