"""Files that are damaged, foreign, newer, locked or read-only."""

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from datetime import UTC, datetime
from pathlib import Path

import pytest

from storage import Store, StoreError, open_store
from storage.sqlite import sqlite3
from storage.tables.ddl import MIGRATIONS
from tests.storage.file.refusals import code_of

NOON = datetime(2026, 11, 21, 12, 0, 0, tzinfo=UTC)
IS_ROOT = hasattr(os, "geteuid") and os.geteuid() == 0


def filled(path: Path, n_groups: int = 200) -> bytes:
    with open_store(path) as store:
        for n in range(n_groups):
            store.groups.create(f"Grupo {n}")
    return path.read_bytes()


def garbled_header(content: bytes) -> bytes:
    return b"this is no database" + content[19:]


def garbled_middle(content: bytes) -> bytes:
    middle = len(content) // 2 // 4096 * 4096
    return content[:middle] + os.urandom(4096 * 3) + content[middle + 4096 * 3 :]


def cut_short(content: bytes) -> bytes:
    return content[: len(content) * 2 // 3]


def all_garbled(content: bytes) -> bytes:
    return garbled_header(os.urandom(len(content)))


@pytest.mark.parametrize(
    ("damage", "code", "n_recovered"),
    [
        (garbled_header, "database_salvaged_alone", 200),
        (garbled_middle, "database_salvaged_alone", 100),
        (cut_short, "database_set_aside", 0),
        (all_garbled, "database_set_aside", 0),
    ],
)
def test_a_damaged_file_is_set_aside_untouched_and_a_new_one_begun_with_what_can_be_read_of_it(
    path: Path,
    opened: Callable[..., Store],
    damage: Callable[[bytes], bytes],
    code: str,
    n_recovered: int,
) -> None:
    damaged = damage(filled(path))
    path.write_bytes(damaged)
    store = opened(clock=lambda: NOON)
    assert store.notice is not None
    assert store.notice.code == code
    aside = path.with_name("pinel.damaged-20261121-120000.db")
    assert store.notice.params["name"] == aside.name
    assert aside.read_bytes() == damaged
    assert len(store.groups.all()) >= n_recovered
    assert store.groups.create("A").name == "A"


def test_two_files_damaged_in_the_same_second_are_both_kept(path: Path) -> None:
    for _ in range(2):
        path.write_bytes(b"no database, but long enough to be taken for one" * 99)
        open_store(path, clock=lambda: NOON).close()
    assert len(list(path.parent.glob("pinel.damaged-*.db"))) == 2


def test_an_empty_file_is_a_new_database(path: Path, opened: Callable[..., Store]) -> None:
    path.touch()
    assert opened().notice is None


def test_a_file_of_a_newer_program_is_refused_and_not_touched(path: Path) -> None:
    filled(path, 1)
    with sqlite3.connect(path) as db:
        db.execute(
            "INSERT INTO _sqlite_migrations (migration_set, name, applied_at) VALUES ('pinel', 'lessons', '2031')"
        )
    db.close()
    before = path.read_bytes()
    assert code_of(lambda: open_store(path)) == "database_newer"
    assert path.read_bytes() == before


def test_a_file_of_another_program_is_refused_and_not_touched(path: Path) -> None:
    with sqlite3.connect(path) as db:
        db.execute("CREATE TABLE recipes (name TEXT)")
    db.close()
    before = path.read_bytes()
    assert code_of(lambda: open_store(path)) == "database_foreign"
    assert path.read_bytes() == before
    assert os.listdir(path.parent) == ["pinel.db"]


def test_a_file_whose_making_was_cut_off_is_made_to_its_end(
    path: Path, opened: Callable[..., Store], monkeypatch: pytest.MonkeyPatch
) -> None:
    def cut_off() -> Iterator[str]:
        raise KeyboardInterrupt
        yield

    for name in MIGRATIONS:
        with monkeypatch.context() as patch:
            patch.setitem(MIGRATIONS, name, cut_off())
            with pytest.raises(KeyboardInterrupt):
                open_store(path)
    assert opened().groups.create("A").name == "A"


def test_a_folder_in_place_of_the_file_is_an_error_with_a_code(path: Path) -> None:
    path.mkdir()
    assert code_of(lambda: open_store(path)) in ("database_read_only", "database_failed")


def test_a_file_in_place_of_the_folder_is_an_error_with_a_code(tmp_path: Path) -> None:
    (tmp_path / "data").write_text("not a folder")
    assert code_of(lambda: open_store(tmp_path / "data" / "pinel.db")) == "database_read_only"


def test_without_a_file_there_is_nothing_to_read_and_every_write_says_why(path: Path) -> None:
    refusal = StoreError("database_newer", path=str(path))
    with Store.without_file(path, refusal) as store:
        assert store.groups.all() == []
        assert store.settings.get("language") is None
        assert code_of(lambda: store.groups.create("A")) == "database_newer"
        assert (store.writable, store.notice and store.notice.code) == (False, "database_newer")


def test_a_file_that_another_program_holds_is_locked_and_free_again_later(
    store: Store, path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    store._database.submit(lambda db: db.execute("PRAGMA busy_timeout = 50").fetchone()).result()
    other = sqlite3.connect(path, isolation_level=None)
    other.execute("BEGIN EXCLUSIVE")
    assert code_of(lambda: store.groups.create("A")) == "database_locked"
    other.execute("ROLLBACK")
    other.close()
    assert store.groups.create("A").name == "A"


READ_ONLY_SCRIPT = """
import os, sys
from pathlib import Path
sys.path[:0] = {import_path!r}
path, user = Path(sys.argv[1]), 65534
import storage, numpy
if os.geteuid() == 0:
    os.setgroups([]); os.setgid(user); os.setuid(user)
store = storage.open_store(path, close_interrupted=True)
print(store.writable, store.notice and store.notice.code)
print([group.name for group in store.groups.all()])
try:
    store.groups.create("B")
except storage.StoreError as error:
    print(error.code)
store.close()
"""


def opened_read_only(path: Path, mode_of_folder: int) -> subprocess.CompletedProcess[str]:
    """What an ordinary user sees who may not write the file: of a copy, as pytest closes its folders to others."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for file in path.parent.glob(f"{path.name}*"):
            shutil.copy(file, folder / file.name)
        (folder / path.name).chmod(0o444)
        folder.chmod(mode_of_folder)
        script = READ_ONLY_SCRIPT.format(import_path=sys.path)
        result = subprocess.run(
            [sys.executable, "-c", script, str(folder / path.name)],
            capture_output=True,
            text=True,
            check=False,
        )
        folder.chmod(0o755)
        left = {file.name for file in path.parent.glob(f"{path.name}*")}
        assert {file.name for file in folder.iterdir()} >= left  # nothing was deleted
    return result


@pytest.mark.skipif(sys.platform == "win32", reason="permissions of POSIX")
@pytest.mark.parametrize("mode_of_folder", [0o755, 0o555])
def test_a_read_only_file_can_be_read_and_says_that_it_cannot_be_written(
    path: Path, mode_of_folder: int
) -> None:
    filled(path, 1)
    result = opened_read_only(path, mode_of_folder)
    assert result.stderr == ""
    assert result.stdout.splitlines() == [
        "False database_read_only",
        "['Grupo 0']",
        "database_read_only",
    ]


@pytest.mark.skipif(sys.platform == "win32", reason="permissions of POSIX")
def test_of_a_read_only_folder_with_a_left_wal_it_is_said_that_the_last_edits_are_not_shown(
    path: Path, tmp_path: Path
) -> None:
    filled(path, 1)
    copy = tmp_path / "copy" / path.name
    copy.parent.mkdir()
    with open_store(path) as store:
        store.groups.create("B")  # is in the WAL only
        for name in (path.name, f"{path.name}-wal"):
            shutil.copy(path.with_name(name), copy.with_name(name))
    result = opened_read_only(copy, 0o555)
    assert result.stderr == ""
    assert result.stdout.splitlines()[:2] == ["False database_without_last_edits", "['Grupo 0']"]
