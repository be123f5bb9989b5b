"""Values that no PINEL writes, looked for at each start: somebody made them up, or a bit of them is wrong.

Settings that cannot be read would keep PINEL from starting: those of the newest backup are taken, else they begin anew.
"""

import logging
from collections.abc import Iterator
from contextlib import closing, suppress
from pathlib import Path

from storage.file.notices import Notice
from storage.limits import MAX_NUMBERS_AHEAD, MAX_REVISION
from storage.sql import opened, tuples
from storage.sqlite import sqlite3
from storage.text import FIRST_MADE_UP_ID, IS_ID, is_json

_log = logging.getLogger(__name__)
_ALL = "SELECT CAST(key AS BLOB), CAST(value AS BLOB) FROM settings"
_REVISED = (
    "computers",
    "classrooms",
    "groups",
    "lessons",
    "own_activities",
    "class_presets",
    "programs",
    "notes",
    "version_labels",
)
_WITH_ID = (*_REVISED, "taught_signs", "versions", "runs", "tombstones")


def holds_made_up(connection: sqlite3.Connection) -> bool:
    """Whether a row has an id, a number or a revision that no PC makes, so that no other PC takes it."""
    if _holds_made_up_ids(connection):
        return True
    revisions = (f"SELECT 1 FROM {name} WHERE revision > ?1" for name in _REVISED)
    numbers = "SELECT 1 FROM versions GROUP BY program_id HAVING max(number) > count(*) + ?2"
    limits = [MAX_REVISION, MAX_NUMBERS_AHEAD]
    found = connection.execute(" UNION ALL ".join((*revisions, numbers)) + " LIMIT 1", limits)
    return found.fetchone() is not None


def _holds_made_up_ids(connection: sqlite3.Connection) -> bool:
    return any(_has_made_up_id(connection, name) for name in _WITH_ID)


def _has_made_up_id(connection: sqlite3.Connection, table: str) -> bool:
    """Asks the index, which is quick, then the table itself: the bit that is wrong may be one of the index."""
    asked = f"SELECT 1 FROM {table} {{how}} WHERE id >= ? AND {IS_ID} LIMIT 1"
    return all(
        connection.execute(asked.format(how=how), [FIRST_MADE_UP_ID]).fetchone()
        for how in ("", "NOT INDEXED")
    )


def damaged_ids(connection: sqlite3.Connection) -> str:
    """A wrong bit can make an id look like one that somebody made up; then it fits no other row. "" where all fit."""
    if not _holds_made_up_ids(connection):
        return ""
    from storage.file.made_up import is_damage  # noqa: PLC0415 - hardly any start needs it

    return "ids" if is_damage(connection) else ""


def mend_settings(db: sqlite3.Connection, path: Path) -> Notice | None:
    """Mends the settings of the database that lies at the path; None where all can be read."""
    damaged = [key for key, value in _rows(db) if not is_json(value)]
    for key in damaged:
        right = _from_backups(path, key)
        if right is None:
            db.execute("DELETE FROM settings WHERE key = ?", [key])
        else:
            db.execute("UPDATE settings SET value = ? WHERE key = ?", [right, key])
        _log.warning("setting %s was damaged; from a backup: %s", key, right is not None)
    return Notice("settings_mended", {"n": len(damaged)}) if damaged else None


def _rows(db: sqlite3.Connection) -> Iterator[tuple[str, bytes]]:
    for key, value in tuples(db, _ALL):
        yield key.decode("utf-8", "replace"), value


def _from_backups(path: Path, key: str) -> str | None:
    from storage.file.backups import list_backups  # noqa: PLC0415 - hardly any start needs them

    for backup in list_backups(path):
        with suppress(sqlite3.Error), closing(opened(backup.path, "immutable")) as db:
            for name, value in _rows(db):
                if name == key and is_json(value):
                    return value.decode()
    return None
