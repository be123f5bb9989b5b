"""The mark: a small file beside the database that knows how often it was saved to.

The database counts its commits in `user_version`. After each the mark is written too, without waiting for the disk: so
it is never ahead of what is on disk, and a database that knows fewer commits than its mark has lost some, or an earlier
copy of it was put back.
"""

import json
import os
from contextlib import suppress
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from storage.side_files import open_regular, read_regular
from storage.sqlite import sqlite3
from storage.text import local_time

_LENGTH = 96  # bytes, always the same: it is overwritten in place
_LAST = 2**31 - 1  # of `user_version`


@dataclass(frozen=True, slots=True)
class CommitRecord:
    """Commits that the database had, and when the last of them was."""

    n_saves: int
    at: str


def path_of(database: Path) -> Path:
    """Where the mark of a database lies."""
    return database.with_name(f"{database.name}.mark.json")


def read_counter(database: Path) -> CommitRecord | None:
    """What the mark says; None where there is none, or where it cannot be read."""
    with suppress(OSError, ValueError, TypeError, KeyError, RecursionError, OverflowError):
        found = json.loads(read_regular(path_of(database)))
        n_saves, at = found["saves"], found["at"]
        if isinstance(n_saves, int) and datetime.fromisoformat(at).tzinfo and local_time(at):
            return CommitRecord(n_saves, at)
    return None


class CommitCounter:
    """The mark of an open database, which is written after each commit; close it.

    A folder that cannot be written goes without.
    """

    def __init__(self, database: Path) -> None:
        self._handle: int | None = None
        with suppress(OSError):
            self._handle = open_regular(path_of(database), os.O_WRONLY | os.O_CREAT)

    def write(self, n_saves: int, at: str) -> None:
        """Overwrites the mark; `at` is the time as text."""
        if self._handle is not None:
            with suppress(OSError):
                os.lseek(self._handle, 0, os.SEEK_SET)
                text = f'{{"saves": {n_saves}, "at": "{at}"}}'
                os.write(self._handle, text.encode().ljust(_LENGTH - 1) + b"\n")

    def close(self) -> None:
        """Lets go of the file."""
        if self._handle is not None:
            os.close(self._handle)
            self._handle = None


def write_counter(database: Path, n_saves: int, at: str) -> None:
    """Writes the mark of a database that is not open."""
    mark = CommitCounter(database)
    mark.write(n_saves, at)
    mark.close()


def ensure_counter(database: Path, n_saves: int, at: str) -> None:
    """Makes the mark where it is missing or was of another file."""
    known = read_counter(database)
    if known is None or known.n_saves != n_saves:
        write_counter(database, n_saves, at)


def commit_count(db: sqlite3.Connection) -> int:
    """Commits that the database has counted."""
    return int(db.execute("PRAGMA user_version").fetchone()[0])


def count_save(db: sqlite3.Connection) -> int:
    """Counts one more within the transaction; returns the number."""
    return set_saves(db, commit_count(db) + 1)


def set_saves(db: sqlite3.Connection, n_saves: int) -> int:
    """Sets the count within the transaction, up to the greatest that the file can hold; returns it."""
    n_saves = min(n_saves, _LAST)
    db.execute(f"PRAGMA user_version = {n_saves}")
    return n_saves
