"""The commit counter: a small file beside the database (`.mark.json`) with the number of its commits.

The database counts its commits in `user_version`. The file is written after each commit, without fsync, so its
number is never ahead of the commits on disk. If a database has fewer commits than its file, it has lost some, or an
earlier copy of it was put back.
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

_LENGTH = 96  # bytes, always the same, as the file is overwritten in place
_LAST = 2**31 - 1  # maximum of `user_version`


@dataclass(frozen=True, slots=True)
class CommitRecord:
    """The number of commits of the database, and the time of the last one."""

    n_saves: int
    at: str


def path_of(database: Path) -> Path:
    """Returns the path of a database's commit counter."""
    return database.with_name(f"{database.name}.mark.json")


def read_counter(database: Path) -> CommitRecord | None:
    """Returns the content of the commit counter; None if it is missing or cannot be read."""
    with suppress(OSError, ValueError, TypeError, KeyError, RecursionError, OverflowError):
        found = json.loads(read_regular(path_of(database)))
        n_saves, at = found["saves"], found["at"]
        if isinstance(n_saves, int) and datetime.fromisoformat(at).tzinfo and local_time(at):
            return CommitRecord(n_saves, at)
    return None


class CommitCounter:
    """The commit counter of an open database, written after each commit; close it.

    If the folder cannot be written, the file is missing; the database still counts its commits.
    """

    def __init__(self, database: Path) -> None:
        self._handle: int | None = None
        with suppress(OSError):
            self._handle = open_regular(path_of(database), os.O_WRONLY | os.O_CREAT)

    def write(self, n_saves: int, at: str) -> None:
        """Overwrites the commit counter; `at` is the time as text."""
        if self._handle is not None:
            with suppress(OSError):
                os.lseek(self._handle, 0, os.SEEK_SET)
                text = f'{{"saves": {n_saves}, "at": "{at}"}}'
                os.write(self._handle, text.encode().ljust(_LENGTH - 1) + b"\n")

    def close(self) -> None:
        """Closes the file."""
        if self._handle is not None:
            os.close(self._handle)
            self._handle = None


def write_counter(database: Path, n_saves: int, at: str) -> None:
    """Writes the commit counter of a database that is not open."""
    counter = CommitCounter(database)
    counter.write(n_saves, at)
    counter.close()


def ensure_counter(database: Path, n_saves: int, at: str) -> None:
    """Writes the commit counter if it is missing or does not match the database."""
    known = read_counter(database)
    if known is None or known.n_saves != n_saves:
        write_counter(database, n_saves, at)


def commit_count(db: sqlite3.Connection) -> int:
    """Returns the number of commits that the database has counted."""
    return int(db.execute("PRAGMA user_version").fetchone()[0])


def count_save(db: sqlite3.Connection) -> int:
    """Counts one commit more within the transaction; returns the number."""
    return set_saves(db, commit_count(db) + 1)


def set_saves(db: sqlite3.Connection, n_saves: int) -> int:
    """Sets the count within the transaction, up to the maximum of `user_version`; returns it."""
    n_saves = min(n_saves, _LAST)
    db.execute(f"PRAGMA user_version = {n_saves}")
    return n_saves
