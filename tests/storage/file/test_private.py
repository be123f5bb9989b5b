"""The data folder belongs to one account; leftovers of killed processes go."""

import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import pytest

from storage import Store
from storage.file.private import restrict_permissions
from storage.file.temporary import remove_leftovers, temporary_folder

pytestmark = pytest.mark.skipif(os.name != "posix", reason="permissions of POSIX")
HOLDING = """
import sys
from storage.file.temporary import temporary_folder
with temporary_folder() as folder:
    (folder / "bundle").write_bytes(b"x")
    print(folder, flush=True)
    sys.stdin.read()
"""


def mode(path: Path) -> int:
    return path.stat().st_mode & 0o7777


@pytest.fixture
def shown(tmp_path: Path) -> Path:
    """A database of an earlier release, which other accounts could read."""
    folder = tmp_path / "pinel"
    (folder / "backups").mkdir(parents=True)
    for path in (folder, folder / "backups"):
        path.chmod(0o775)
    names = (
        "pinel.db",
        "pinel.db-wal",
        "pinel.db.page.json",
        "pinel.log",
        "backups/pinel-00001.db",
        "other",
    )
    for name in names:
        (folder / name).write_text("")
        (folder / name).chmod(0o664)
    return folder / "pinel.db"


def test_what_others_could_read_is_private_after_a_start(shown: Path) -> None:
    restrict_permissions(shown, is_own_folder=True)
    folder = shown.parent
    assert (mode(folder), mode(folder / "backups")) == (0o700, 0o700)
    for name in (
        "pinel.db",
        "pinel.db-wal",
        "pinel.db.page.json",
        "pinel.log",
        "backups/pinel-00001.db",
    ):
        assert mode(folder / name) == 0o600
    assert mode(folder / "other") == 0o664


@pytest.mark.parametrize(("is_own", "bits"), [(False, 0o775), (True, 0o2775)])
def test_a_folder_that_is_shared_on_purpose_stays_so(shown: Path, is_own: bool, bits: int) -> None:
    shown.parent.chmod(bits)
    restrict_permissions(shown, is_own_folder=is_own)
    assert (mode(shown.parent), mode(shown)) == (bits, 0o664)


def test_in_a_folder_of_a_group_its_accounts_may_write_what_sqlite_made(shown: Path) -> None:
    shown.parent.chmod(0o2770)
    for file in (shown, shown.with_name("pinel.db-wal"), shown.parent / "backups"):
        file.chmod(0o755 if file.is_dir() else 0o644)
    restrict_permissions(shown, is_own_folder=False)
    assert (mode(shown), mode(shown.with_name("pinel.db-wal"))) == (0o664, 0o664)
    assert (mode(shown.parent / "backups"), mode(shown.parent / "other")) == (0o775, 0o664)


def test_a_folder_that_is_made_is_private(tmp_path: Path, opened: Callable[..., Store]) -> None:
    store = opened(tmp_path / "new" / "pinel.db")
    restrict_permissions(store.path, is_own_folder=False)
    assert (mode(tmp_path / "new"), mode(store.path)) == (0o700, 0o600)
    assert mode(tmp_path / "new" / "pinel.db-wal") == 0o600


def test_leftovers_go_at_once_but_not_those_of_a_process_that_lives(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    environment = {**os.environ, "TMPDIR": str(tmp_path)}
    with subprocess.Popen(
        [sys.executable, "-c", HOLDING],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        env=environment,
    ) as process:
        assert process.stdout is not None
        folder = Path(process.stdout.readline().decode().strip())
        with temporary_folder() as mine:
            remove_leftovers()
            assert (folder / "bundle").exists()
            assert mine.exists()
        process.kill()
    assert folder.exists()
    remove_leftovers()
    assert not folder.exists()
