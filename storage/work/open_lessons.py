"""The lesson that is open on this PC, for each class.

All PCs that opened a lesson share its row, which after a merge describes the last use on another PC. So the lesson that
is open on this PC is stored in the settings, which no merge changes.
"""

import math
from datetime import datetime
from typing import NamedTuple

from storage.file.connection import Timestamp
from storage.sql import rows_of
from storage.sqlite import sqlite3
from storage.work.settings import read_setting, write_setting

# s; after such a pause another class is at the PC
_PAUSE_S = 45 * 60
_MAX_OPENED_PAUSE_S = 6 * 3600
# for files of releases that did not store it in the settings
_BY_ROW = """
    SELECT id, used_at FROM lessons WHERE closed_at IS NULL AND computer_id = ? AND classroom_id IS ?
    ORDER BY by_itself, used_at DESC LIMIT 1"""


class OpenLesson(NamedTuple):
    """The lesson that was opened last on this PC for a class and not closed, and its last use on this PC."""

    id: str
    by_itself: bool
    used: Timestamp

    def is_current(self, now: Timestamp) -> bool:
        """Returns whether a group worked in it recently enough."""
        return _pause_s(self.used, now) <= (_PAUSE_S if self.by_itself else _MAX_OPENED_PAUSE_S)


def open_lesson(
    db: sqlite3.Connection, classroom_id: str | None, computer_id: str
) -> OpenLesson | None:
    """Returns the open lesson of the class; None if none was opened on this PC, or it was closed or deleted."""
    lesson_id, used = _stored_open_lesson(db, classroom_id, computer_id)
    query = "SELECT by_itself FROM lessons WHERE id = ? AND classroom_id IS ?"
    found = db.execute(query, [lesson_id, classroom_id]).fetchone()
    return OpenLesson(lesson_id, bool(found["by_itself"]), used) if found else None


def set_open_lesson(
    db: sqlite3.Connection,
    classroom_id: str | None,
    computer_id: str,
    lesson_id: str | None,
    now: Timestamp,
) -> None:
    """Stores which lesson of the class is open on this PC and used now, None for none."""
    lesson = {"computer": computer_id, "lesson": lesson_id, "used": now}
    write_setting(db, _name(classroom_id), lesson)


def _stored_open_lesson(
    db: sqlite3.Connection, classroom_id: str | None, computer_id: str
) -> tuple[str, Timestamp]:
    """Returns the key of the lesson, "" for none, and the time of its last use."""
    match read_setting(db, _name(classroom_id)):
        # otherwise the data folder was copied from another PC, or the value is damaged
        case {
            "computer": of,
            "lesson": lesson,
            "used": [str(at), str(app), int() | float() as s],
        } if of == computer_id:
            return lesson or "", Timestamp(at, app, s)
    rows = rows_of(db, _BY_ROW, [computer_id, classroom_id])
    return (
        (rows[0]["id"], Timestamp(rows[0]["used_at"], "", 0.0))
        if rows
        else ("", Timestamp("", "", 0.0))
    )


def _name(classroom_id: str | None) -> str:
    return f"open_lesson {classroom_id or 'none'}"


def _pause_s(used: Timestamp, now: Timestamp) -> float:
    """Returns the pause in s: by monotonic time within one app, by the PC's clock after a restart."""
    if used.app == now.app:
        return now.uptime_s - used.uptime_s
    try:
        pause = datetime.fromisoformat(now.text) - datetime.fromisoformat(used.text)
    except (ValueError, TypeError):  # a damaged value: a new lesson starts
        return math.inf
    return abs(pause.total_seconds())  # the clock may have been set back meanwhile
