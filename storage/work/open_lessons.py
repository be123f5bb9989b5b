"""Which lesson is open on this PC, for each class.

A lesson's row is shared by all PCs that it was opened on, so it cannot tell: after a merge it says what another PC did
last. What is open on this PC is kept among the settings, which no merge changes.
"""

import math
from datetime import datetime
from typing import NamedTuple

from storage.file.connection import Timestamp
from storage.sql import rows_of
from storage.sqlite import sqlite3
from storage.work.settings import read_setting, write_setting

# after so long a pause another class is at the PC
_PAUSE_S = 45 * 60
_MAX_OPENED_PAUSE_S = 6 * 3600
# for files of releases that did not note it in the settings
_BY_ROW = """
    SELECT id, used_at FROM lessons WHERE closed_at IS NULL AND computer_id = ? AND classroom_id IS ?
    ORDER BY by_itself, used_at DESC LIMIT 1"""


class OpenLesson(NamedTuple):
    """What was opened last on this PC for a class and not closed, and when it was last used on it."""

    id: str
    by_itself: bool
    used: Timestamp

    def is_current(self, now: Timestamp) -> bool:
        """Whether a group worked in it recently enough."""
        return _pause_s(self.used, now) <= (_PAUSE_S if self.by_itself else _MAX_OPENED_PAUSE_S)


def open_lesson(
    db: sqlite3.Connection, classroom_id: str | None, computer_id: str
) -> OpenLesson | None:
    """None where none was opened on this PC, where it was closed, and where it was deleted."""
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
    """Notes which lesson of the class is open on this PC and used now, None for none."""
    mark = {"computer": computer_id, "lesson": lesson_id, "used": now}
    write_setting(db, _name(classroom_id), mark)


def _stored_open_lesson(
    db: sqlite3.Connection, classroom_id: str | None, computer_id: str
) -> tuple[str, Timestamp]:
    """Key of the lesson, "" for none, and when it was used."""
    match read_setting(db, _name(classroom_id)):
        # else the folder was copied, or the disk has damaged it
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
    """Within one app the clock may be set as it likes; across a start there is nothing but the clock."""
    if used.app == now.app:
        return now.uptime_s - used.uptime_s
    try:
        pause = datetime.fromisoformat(now.text) - datetime.fromisoformat(used.text)
    except (ValueError, TypeError):  # damaged by the disk: a new lesson begins
        return math.inf
    return abs(pause.total_seconds())  # the clock may have been set back in between
