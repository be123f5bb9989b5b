"""Values that PINEL never writes and that a wrong bit makes; each start searches for them.

A setting that cannot be read would prevent the start. It is restored from the newest backup, else deleted.
"""

import logging
from collections.abc import Iterator
from contextlib import closing, suppress
from pathlib import Path

from storage.file.notices import Notice
from storage.sql import opened, tuples
from storage.sqlite import sqlite3
from storage.text import FIRST_IMPLAUSIBLE_ID, IS_ID, is_json

_log = logging.getLogger(__name__)
_ALL = "SELECT CAST(key AS BLOB), CAST(value AS BLOB) FROM settings"
_WITH_ID = (
    "computers",
    "classrooms",
    "groups",
    "lessons",
    "own_activities",
    "calibrated_robots",
    "class_presets",
    "programs",
    "notes",
    "truths",
    "version_labels",
    "taught_signs",
    "versions",
    "runs",
    "tombstones",
)
_ORPHAN_CHECKSUMS = """SELECT 1 FROM content_sums WHERE table_name IN ('versions', 'runs')
    AND row_id NOT IN (SELECT id FROM versions UNION ALL SELECT id FROM runs
                       UNION ALL SELECT id FROM tombstones) LIMIT 1"""


def _has_implausible_id(connection: sqlite3.Connection, table: str) -> bool:
    """Queries the index, which is quick, then the table itself, as the wrong bit may be in the index."""
    asked = f"SELECT 1 FROM {table} {{how}} WHERE id >= ? AND {IS_ID} LIMIT 1"
    return all(
        connection.execute(asked.format(how=how), [FIRST_IMPLAUSIBLE_ID]).fetchone()
        for how in ("", "NOT INDEXED")
    )


def damaged_ids(db: sqlite3.Connection) -> str:
    """Returns "ids" if damage made an id implausible, "" for no damage.

    Then child rows or the checksum of the row still have the original id.
    """
    if not any(_has_implausible_id(db, name) for name in _WITH_ID):
        return ""
    violation = tuples(db, "PRAGMA foreign_key_check").fetchone()
    return "ids" if violation or tuples(db, _ORPHAN_CHECKSUMS).fetchone() else ""


def repair_settings(db: sqlite3.Connection, path: Path) -> Notice | None:
    """Repairs the settings of the database at the path; returns None if all can be read."""
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
    from storage.file.backups import list_backups  # noqa: PLC0415 - rarely needed at a start

    for backup in list_backups(path):
        with suppress(sqlite3.Error), closing(opened(backup.path, "immutable")) as db:
            for name, value in _rows(db):
                if name == key and is_json(value):
                    return value.decode()
    return None
