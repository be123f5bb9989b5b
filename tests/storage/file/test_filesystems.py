"""Files in places where SQLite's WAL does not work: network shares, disks that share no memory. Folders in memory."""

from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

import pytest

from storage import Store, StoreError
from storage.file import filesystems, opening
from storage.file.backups import list_backups, make_backup
from storage.file.filesystems import is_in_memory, mount_of
from storage.sql import address
from storage.sqlite import sqlite3

NOON = datetime(2026, 11, 21, 12, 0, 0, tzinfo=UTC)
MOUNTS = """\
22 1 254:0 / / rw,relatime - ext4 /dev/vda rw
30 22 0:25 / /proc rw,nosuid - proc proc rw
41 22 0:40 / /home/turma\\0401 rw,relatime shared:5 - cifs //server/turma rw,vers=3.0
42 22 0:41 / /srv rw - nfs4 server:/srv rw
43 42 0:42 / /srv/local rw - xfs /dev/vdb rw
"""


@pytest.mark.parametrize(
    ("folder", "kind"),
    [
        ("/home/ana", "ext4"),
        ("/home/turma 1/pinel", "cifs"),
        ("/home/turma 10", "ext4"),
        ("/srv", "nfs4"),
        ("/srv/local/x", "xfs"),
    ],
)
def test_the_kind_of_a_file_system_is_that_of_the_nearest_mount(folder: str, kind: str) -> None:
    assert mount_of(Path(folder), MOUNTS)[0] == kind


# overlayroot, a live system (its layers are out of sight), a layer on the disk, a home in memory as of a guest
RESETTING = """\
22 1 0:22 / / rw,relatime - overlay overlay rw,lowerdir=/run/ro,upperdir=/run/rw/up\\0401,workdir=/run/rw/work
23 22 0:23 / /run/rw rw - tmpfs tmpfs-root rw,size=9k
24 22 0:24 / /cow/seen rw - overlay /cow rw,lowerdir=/a,upperdir=/gone/upper,workdir=/gone/work
25 22 254:0 / /disk rw - ext4 /dev/vda rw
26 22 0:26 / /kept rw - overlay overlay rw,lowerdir=/a,upperdir=/disk/upper,workdir=/disk/work
27 22 0:27 / /home/guest rw - tmpfs none rw
28 22 0:28 / /old rw - aufs none rw,si=4f
"""


@pytest.mark.parametrize(
    ("folder", "expected"),
    [
        ("/home/ana/.local/share/pinel", True),
        ("/cow/seen", True),
        ("/home/guest/pinel", True),
        ("/old", True),
        ("/disk/pinel", False),
        ("/kept", False),
    ],
)
def test_a_folder_that_is_as_before_at_the_next_start_is_known(
    folder: str, expected: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    mounts = tmp_path / "mountinfo"
    mounts.write_text(RESETTING, "utf-8")
    monkeypatch.setattr(filesystems, "_MOUNTS", mounts)
    assert is_in_memory(Path(folder)) is expected
    mounts.unlink()
    assert not is_in_memory(Path(folder))


def test_a_folder_of_this_pc_is_no_share_and_the_file_uses_its_wal(
    store: Store, path: Path
) -> None:
    assert not filesystems.is_on_share(path.parent)
    assert journal_mode(path) == "wal"
    assert store.notice is None


def journal_mode(path: Path) -> str:
    db = sqlite3.connect(path)
    mode = str(db.execute("PRAGMA journal_mode").fetchone()[0])
    db.close()
    return mode


def save_program(store: Store) -> None:
    program = store.programs.create(store.groups.create("A").id, "P")
    store.versions.save(program.id, {"n": 1}, None)


def check_that_work_is_stored_without_wal(opened: Callable[..., Store], path: Path) -> None:
    store = opened()
    assert store.writable
    assert store.notice is not None
    assert store.notice.code == "database_on_share"
    (group,) = store.groups.all()
    (program,) = store.programs.of_group(group.id)
    store.versions.save(program.id, {"n": 2}, None)
    other = opened()
    newest = other.versions.newest(program.id)
    assert newest is not None
    assert newest.workspace == {"n": 2}
    synchronous = store._database.write(lambda db: db.execute("PRAGMA synchronous").fetchone()[0])
    assert synchronous == 2
    assert not path.with_name("pinel.db-wal").exists()


def test_on_a_network_share_the_file_is_written_without_wal_and_that_is_told(
    opened: Callable[..., Store], path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with opened() as store:
        save_program(store)
    monkeypatch.setattr(opening, "is_on_share", lambda folder: True)
    check_that_work_is_stored_without_wal(opened, path)
    assert journal_mode(path) == "delete"
    monkeypatch.undo()
    with opened() as store:
        assert store.notice is None
        assert journal_mode(path) == "wal"


@pytest.mark.parametrize("vfs", ["unix-dotfile", "unix-none"])
@pytest.mark.parametrize("had_wal", [True, False], ids=["copied there", "made there"])
def test_where_sqlite_can_share_no_memory_the_file_is_written_without_wal_and_that_is_told(
    opened: Callable[..., Store],
    path: Path,
    monkeypatch: pytest.MonkeyPatch,
    vfs: str,
    had_wal: bool,
) -> None:
    real = address
    with monkeypatch.context() as patch:
        if not had_wal:
            patch.setattr(opening, "address", lambda p, mode: f"{real(p, mode)}&vfs={vfs}")
        with opened() as store:
            save_program(store)
    monkeypatch.setattr(opening, "address", lambda p, mode: f"{real(p, mode)}&vfs={vfs}")
    check_that_work_is_stored_without_wal(opened, path)


def test_a_wal_that_came_with_the_file_is_taken_in_where_there_can_be_none(
    opened: Callable[..., Store], path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    store = opened()
    save_program(store)
    there = tmp_path / "there" / "pinel.db"
    there.parent.mkdir()
    for suffix in ("", "-wal"):
        there.with_name(there.name + suffix).write_bytes(
            path.with_name(path.name + suffix).read_bytes()
        )
    real = address
    monkeypatch.setattr(opening, "address", lambda p, mode: f"{real(p, mode)}&vfs=unix-dotfile")
    assert [group.name for group in opened(there).groups.all()] == ["A"]


def test_a_backup_of_a_file_without_wal_is_given_up_while_somebody_writes_all_the_time(
    opened: Callable[..., Store], path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(opening, "is_on_share", lambda folder: True)
    monkeypatch.setattr("storage.file.backups._PAGES", 4)
    store = opened()
    save_program(store)
    (program,) = store.programs.of_group(store.groups.all()[0].id)
    store.versions.save(program.id, {"text": "x" * 400_000}, None)
    n_saved = 0

    def stop() -> bool:
        nonlocal n_saved
        n_saved += 1
        store.versions.save(program.id, {"during": n_saved}, None)
        return False

    with pytest.raises(StoreError) as caught:
        make_backup(path, NOON, free=lambda _: 10**12, stop=stop)
    assert caught.value.code == "backup_failed"
    assert list_backups(path) == []
    assert make_backup(path, NOON, free=lambda _: 10**12) is not None
