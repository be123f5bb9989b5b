"""Lessons: meetings of a class, opened by the teacher or by themselves when a group begins to work.

What is made belongs to a lesson by its key, not by its time: the clocks of school PCs are often wrong. A lesson that
the teacher opens has a key made of class and title, so that it is one lesson on all PCs where it was opened.
"""

import sqlite3
import uuid
from collections.abc import Mapping

from storage.classrooms import require_classroom
from storage.computers import here, known
from storage.connection import Access, Moment
from storage.errors import StoreError
from storage.joined import settle, tree_of, whole_of
from storage.open_lessons import keep_open, open_lesson
from storage.records import LessonRow
from storage.text import clean_name, name_key, new_id

_SELECT = """
    SELECT lessons.id, lessons.classroom_id, title, activity, by_itself, computer_id, computers.name AS computer,
           opened_at, used_at, closed_at, part_of,
           (SELECT count(*) FROM versions WHERE lesson_id = lessons.id) AS n_versions,
           (SELECT count(*) FROM runs WHERE lesson_id = lessons.id) AS n_runs
    FROM lessons LEFT JOIN computers ON computers.id = lessons.computer_id"""


class Lessons:
    """The lessons of the file."""

    def __init__(self, access: Access) -> None:
        self._access = access

    def of_classroom(self, classroom_id: str | None) -> list[LessonRow]:
        """Newest first; of groups without a class with None."""
        with self._access.reading() as db:
            rows = db.execute(
                f"{_SELECT} WHERE lessons.classroom_id IS ? ORDER BY opened_at DESC, lessons.id DESC",
                [classroom_id],
            ).fetchall()
            wholes = whole_of(db)
        return [_record(row, wholes) for row in rows]

    def get(self, lesson_id: str) -> LessonRow:
        """Raises StoreError `lesson_not_found`."""
        with self._access.reading() as db:
            row = db.execute(f"{_SELECT} WHERE lessons.id = ?", [lesson_id]).fetchone()
            wholes = whole_of(db)
        if row is None:
            raise StoreError("lesson_not_found", id=lesson_id)
        return _record(row, wholes)

    def current(self, classroom_id: str | None) -> LessonRow | None:
        """What work of the class would belong to now on this PC, None when a new lesson would begin."""
        now = self._access.moment()
        with self._access.reading() as db:
            computer = known(db)
            found = computer and open_lesson(db, classroom_id, computer[0])
        return self.get(found.id) if found and found.goes_on(now) else None

    def parts(self, lesson_id: str) -> list[str]:
        """Keys of the lesson that it belongs to in the end, and of all that were joined to that one."""
        with self._access.reading() as db:
            return tree_of(db, lesson_id)

    def open(self, classroom_id: str, title: str, activity: str | None = None) -> LessonRow:
        """Opens the lesson of that title, again where it was closed; what was open on this PC is closed.

        Raises:
            StoreError: `classroom_not_found`, `name_empty`, `name_too_long`.
        """
        clean, moment = clean_name(title), self._access.moment()
        now = moment.text

        def insert(db: sqlite3.Connection) -> str:
            require_classroom(db, classroom_id)
            lesson_id = _titled(db, classroom_id, clean) or _free_key(db, classroom_id, clean)
            computer_id, _ = here(db, now)
            before = open_lesson(db, classroom_id, computer_id)
            if before and before.id != lesson_id:
                _close(db, before.id, now)
            db.execute(
                """INSERT INTO lessons (id, classroom_id, title, activity, by_itself, computer_id, opened_at, used_at,
                                        changed_at) VALUES (?, ?, ?, ?, 0, ?, ?, ?, ?)
                   ON CONFLICT (id) DO UPDATE SET closed_at = NULL, activity = excluded.activity, by_itself = 0,
                       used_at = excluded.used_at, computer_id = excluded.computer_id,
                       changed_at = excluded.changed_at,
                       revision = revision + (activity IS NOT excluded.activity OR by_itself)""",
                [lesson_id, classroom_id, clean, activity, computer_id, now, now, now],
            )
            keep_open(db, classroom_id, computer_id, lesson_id, moment)
            return lesson_id

        return self.get(self._access.write(insert))

    def close(self, lesson_id: str) -> LessonRow:
        """Ends a lesson. Raises StoreError `lesson_not_found`."""
        classroom_id, moment = self.get(lesson_id).classroom_id, self._access.moment()

        def close(db: sqlite3.Connection) -> None:
            computer = known(db)
            found = computer and open_lesson(db, classroom_id, computer[0])
            if computer and found and found.id == lesson_id:
                keep_open(db, classroom_id, computer[0], None, moment)
            _close(db, lesson_id, moment.text)

        self._access.write(close)
        return self.get(lesson_id)

    def change(self, lesson_id: str, changes: Mapping[str, str | None]) -> LessonRow:
        """Changes some of `title`, `activity` and `part_of`, the lesson that it is to be a part of with all its parts.

        Raises:
            StoreError: `lesson_not_found`; `lesson_not_joinable` to itself, to a part of it, or to another class's.
        """
        wanted, now = dict(changes), self._access.now()
        if "title" in wanted:  # "" as of a lesson that opened by itself
            wanted["title"] = clean_name(wanted["title"]) if wanted["title"] else ""

        def change(db: sqlite3.Connection) -> None:
            if "part_of" in wanted:
                if wanted["part_of"] is not None:
                    wanted["part_of"] = _joinable(db, lesson_id, wanted["part_of"])
                settle(db, lesson_id, now)
            assignments = ", ".join(f"{name} = :{name}" for name in wanted)
            db.execute(
                f"UPDATE lessons SET {assignments}, revision = revision + 1, changed_at = :now WHERE id = :id",
                {**wanted, "now": now, "id": lesson_id},
            )

        if wanted:
            self._access.write(change)
        return self.get(lesson_id)


def lesson_for(db: sqlite3.Connection, group_id: str, now: Moment) -> tuple[str, str]:
    """Keys of the lesson that the group's work belongs to now, and of this PC; within the caller's transaction."""
    computer_id, _ = here(db, now.text)
    group = db.execute("SELECT classroom_id FROM groups WHERE id = ?", [group_id]).fetchone()
    classroom_id = group["classroom_id"]
    found = open_lesson(db, classroom_id, computer_id)
    if found and found.goes_on(now):
        lesson_id = found.id
        # on another PC it may have been closed meanwhile
        query = "UPDATE lessons SET used_at = ?, closed_at = NULL WHERE id = ?"
        db.execute(query, [now.text, lesson_id])
    else:
        if found:
            _close(db, found.id, now.text)
        lesson_id = _begun(db, classroom_id, computer_id, now.text)
    keep_open(db, classroom_id, computer_id, lesson_id, now)
    return lesson_id, computer_id


def _begun(db: sqlite3.Connection, classroom_id: str | None, computer_id: str, now: str) -> str:
    """A lesson that opens by itself."""
    lesson_id = new_id()
    db.execute(
        """INSERT INTO lessons (id, classroom_id, title, by_itself, computer_id, opened_at, used_at, changed_at)
           VALUES (?, ?, '', 1, ?, ?, ?, ?)""",
        [lesson_id, classroom_id, computer_id, now, now, now],
    )
    return lesson_id


def _titled(db: sqlite3.Connection, classroom_id: str, title: str) -> str | None:
    """The newest lesson of the class that has this title now."""
    rows = db.execute(
        "SELECT id, title FROM lessons WHERE classroom_id = ? ORDER BY opened_at DESC, id DESC",
        [classroom_id],
    )
    wanted = name_key(title)
    return next((str(row["id"]) for row in rows if name_key(row["title"]) == wanted), None)


def _free_key(db: sqlite3.Connection, classroom_id: str, title: str) -> str:
    """The same on every PC; another one where the lesson that it was made for is deleted, or has another title now."""
    key = uuid.uuid5(uuid.UUID(classroom_id), name_key(title))
    taken = "SELECT id FROM tombstones WHERE id = :key UNION SELECT id FROM lessons WHERE id = :key"
    while db.execute(taken, {"key": str(key)}).fetchone():
        key = uuid.uuid5(key, "again")
    return str(key)


def _close(db: sqlite3.Connection, lesson_id: str, now: str) -> None:
    """No new state, which would beat the title that the teacher gives meanwhile: lessons also close by themselves."""
    query = "UPDATE lessons SET closed_at = ? WHERE id = ? AND closed_at IS NULL"
    db.execute(query, [now, lesson_id])


def _joinable(db: sqlite3.Connection, lesson_id: str, to: str) -> str:
    """The whole that the lesson can be joined to."""
    rows = db.execute("SELECT id, classroom_id FROM lessons WHERE id IN (?, ?)", [lesson_id, to])
    lessons = {row["id"]: row["classroom_id"] for row in rows}
    if len(lessons) < 2:
        missing = to if lesson_id in lessons and to != lesson_id else lesson_id
        code = "lesson_not_joinable" if to == lesson_id else "lesson_not_found"
        raise StoreError(code, id=missing)
    whole = tree_of(db, to)[0]
    if whole == lesson_id or lessons[lesson_id] != lessons[to]:
        raise StoreError("lesson_not_joinable", id=lesson_id)
    return whole


def _record(row: sqlite3.Row, wholes: Mapping[str, str]) -> LessonRow:
    shown = {"by_itself": bool(row["by_itself"]), "part_of": wholes.get(row["id"])}
    return LessonRow(**{**dict(row), **shown})
