"""Makes and damages backups."""

from datetime import UTC, datetime, timedelta
from pathlib import Path

from storage.file.backups import (
    Backup,
    make_backup,
)
from storage.sqlite import sqlite3

NOON = datetime(2026, 11, 21, 12, 0, 0, tzinfo=UTC)
DAY = timedelta(days=1)
MUCH = 10**12


def much(_folder: Path) -> int:
    return MUCH


def backed_up(path: Path, now: datetime = NOON) -> Backup:
    backup = make_backup(path, now, free=much)
    assert backup is not None
    return backup


def names_in(file: Path) -> list[str]:
    db = sqlite3.connect(f"{file.as_uri()}?mode=ro&immutable=1", uri=True)
    names = [name for (name,) in db.execute("SELECT name FROM groups ORDER BY id")]
    db.close()
    return names


def spoil(path: Path) -> bytes:
    """Damages a file so that the WAL cannot restore it."""
    for suffix in ("-wal", "-shm"):
        path.with_name(path.name + suffix).unlink(missing_ok=True)
    path.write_bytes(b"this is no database" + path.read_bytes()[19:])
    return path.read_bytes()


def ruin(path: Path) -> bytes:
    """Damages a file so that nothing of it can be read."""
    path.write_bytes(b"rubbish" * (path.stat().st_size // 7))
    return path.read_bytes()
