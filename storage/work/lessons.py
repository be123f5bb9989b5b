"""Lessons: meetings of a class, opened by the teacher, or by themselves when a group starts to work.

Work belongs to a lesson by key, not by time, because the clocks of school PCs are often wrong. If the teacher opens a
lesson, its key is made from class and title, so all PCs give it the same key.
"""

import uuid
from collections.abc import Mapping

from storage.errors import StoreError
from storage.file.connection import Timestamp
from storage.file.repository import Repository
from storage.row_types import LessonRow
from storage.sql import insert, not_found, require, rows_of, selected, update_row
from storage.sqlite import sqlite3
from storage.text import clean_name, name_key, new_id
from storage.work.computers import find_computer, this_computer
from storage.work.lesson_joins import flatten, roots, tree_of
from storage.work.open_lessons import open_lesson, set_open_lesson

_SELECT = selected(
    LessonRow,
    "lessons",
    computer="SELECT name FROM computers WHERE computers.id = lessons.computer_id",
    n_versions="SELECT count(*) FROM versions WHERE lesson_id = lessons.id",
    n_runs="SELECT count(*) FROM runs WHERE lesson_id = lessons.id",
)


class Lessons(Repository):
    """The lessons of the file."""

    def of_classroom(self, classroom_id: str | None) -> list[LessonRow]:
        """Returns the lessons of a class, newest first; None for groups without a class."""
        return self._select("classroom_id IS ? ORDER BY opened_at DESC, id DESC", classroom_id)

    def get(self, lesson_id: str) -> LessonRow:
        """Returns a lesson. Raises StoreError `lesson_not_found`."""
        found = self._select("id = ?", lesson_id)
        if not found:
            raise not_found("lessons", lesson_id)
        return found[0]

    def current(self, classroom_id: str | None) -> LessonRow | None:
        """Returns the lesson that new work of the class belongs to on this PC, None if it would start a lesson."""
        now = self._database.timestamp()
        with self._database.read_connection() as db:
            computer = find_computer(db)
            found = computer and open_lesson(db, classroom_id, computer[0])
        return self.get(found.id) if found and found.is_current(now) else None

    def parts(self, lesson_id: str) -> list[str]:
        """Returns the keys of a lesson and of all lessons that were joined with it, the root first."""
        with self._database.read_connection() as db:
            return tree_of(db, lesson_id)

    def open(self, classroom_id: str, title: str, activity: str | None = None) -> LessonRow:
        """Opens the lesson of that title, again if it was closed. Closes the lesson that was open on this PC.

        Raises:
            StoreError: `classroom_not_found`, `name_empty`, `name_too_long`.
        """
        clean, moment = clean_name(title), self._database.timestamp()
        now = moment.text

        def write(db: sqlite3.Connection) -> str:
            require(db, "classrooms", classroom_id)
            lesson_id = _titled(db, classroom_id, clean) or _free_key(db, classroom_id, clean)
            computer_id, _ = this_computer(db, now)
            before = open_lesson(db, classroom_id, computer_id)
            if before and before.id != lesson_id:
                _close(db, before.id, now)
            opened: dict[str, object] = {"activity": activity, "by_itself": 0}
            opened |= {"computer_id": computer_id, "used_at": now, "closed_at": None}
            if not _open_again(db, lesson_id, opened, now):
                made = {"id": lesson_id, "classroom_id": classroom_id, "title": clean}
                insert(db, "lessons", {**made, **opened, "opened_at": now, "changed_at": now})
            set_open_lesson(db, classroom_id, computer_id, lesson_id, moment)
            return lesson_id

        return self.get(self._database.write(write))

    def resume(self, lesson_id: str) -> LessonRow:
        """Opens a lesson that another PC opened, as in its lesson file; does nothing if it is open on this PC.

        This makes no newer state of the lesson: title and activity stay as in the file.

        Raises:
            StoreError: `lesson_not_found`.
        """
        found, moment = self.get(lesson_id), self._database.timestamp()

        def write(db: sqlite3.Connection) -> None:
            computer_id, _ = this_computer(db, moment.text)
            before = open_lesson(db, found.classroom_id, computer_id)
            if before and before.id == lesson_id and before.is_current(moment):
                return
            if before and before.id != lesson_id:
                _close(db, before.id, moment.text)
            query = "UPDATE lessons SET used_at = ?, closed_at = NULL WHERE id = ?"
            db.execute(query, [moment.text, lesson_id])
            set_open_lesson(db, found.classroom_id, computer_id, lesson_id, moment)

        self._database.write(write)
        return self.get(lesson_id)

    def close(self, lesson_id: str) -> LessonRow:
        """Closes a lesson. Raises StoreError `lesson_not_found`."""
        classroom_id, moment = self.get(lesson_id).classroom_id, self._database.timestamp()

        def close(db: sqlite3.Connection) -> None:
            computer = find_computer(db)
            found = computer and open_lesson(db, classroom_id, computer[0])
            if computer and found and found.id == lesson_id:
                set_open_lesson(db, classroom_id, computer[0], None, moment)
            _close(db, lesson_id, moment.text)

        self._database.write(close)
        return self.get(lesson_id)

    def change(self, lesson_id: str, changes: Mapping[str, str | None]) -> LessonRow:
        """Changes some of `title`, `activity` and `part_of`, the lesson to join it to with all its parts.

        Raises:
            StoreError: `lesson_not_found`; `lesson_not_joinable` to itself, to a part of it, or to another class's.
        """
        requested, now = dict(changes), self._database.now()
        if "title" in requested:  # "" is the title of a lesson that opened by itself
            requested["title"] = clean_name(requested["title"]) if requested["title"] else ""

        def write(db: sqlite3.Connection) -> None:
            if "part_of" in requested:
                if requested["part_of"] is not None:
                    requested["part_of"] = _joinable(db, lesson_id, requested["part_of"])
                flatten(db, lesson_id, now)
            update_row(db, "lessons", lesson_id, requested, now)

        if requested:
            self._database.write(write)
        return self.get(lesson_id)

    def _select(self, condition: str, value: str | None) -> list[LessonRow]:
        with self._database.read_connection() as db:
            rows = rows_of(db, f"{_SELECT} WHERE {condition}", [value])
            by_part = roots(db)
        return [_lesson_row(row, by_part) for row in rows]


def lesson_for(db: sqlite3.Connection, group_id: str, now: Timestamp) -> tuple[str, str]:
    """Returns the keys of the group's present lesson and of this PC, within the caller's transaction.

    Starts a lesson if none is open.
    """
    computer_id, _ = this_computer(db, now.text)
    group = db.execute("SELECT classroom_id FROM groups WHERE id = ?", [group_id]).fetchone()
    classroom_id = group["classroom_id"]
    found = open_lesson(db, classroom_id, computer_id)
    if found and found.is_current(now):
        lesson_id = found.id
        # another PC may have closed it meanwhile
        query = "UPDATE lessons SET used_at = ?, closed_at = NULL WHERE id = ?"
        db.execute(query, [now.text, lesson_id])
    else:
        if found:
            _close(db, found.id, now.text)
        lesson_id = _start_lesson(db, classroom_id, computer_id, now.text)
    set_open_lesson(db, classroom_id, computer_id, lesson_id, now)
    return lesson_id, computer_id


def _start_lesson(
    db: sqlite3.Connection, classroom_id: str | None, computer_id: str, now: str
) -> str:
    """Adds a lesson that opens by itself."""
    row = {"id": new_id(), "classroom_id": classroom_id, "title": "", "by_itself": 1}
    row |= {"computer_id": computer_id, "opened_at": now, "used_at": now, "changed_at": now}
    insert(db, "lessons", row)
    return str(row["id"])


def _open_again(
    db: sqlite3.Connection, lesson_id: str, opened: Mapping[str, object], now: str
) -> bool:
    """Opens an existing lesson; returns False if there is none."""
    query = "SELECT activity IS NOT :activity OR by_itself FROM lessons WHERE id = :id"
    row = db.execute(query, {"activity": opened["activity"], "id": lesson_id}).fetchone()
    if row is not None:
        update_row(db, "lessons", lesson_id, opened, now, n_revisions=int(row[0]))
    return row is not None


def _titled(db: sqlite3.Connection, classroom_id: str, title: str) -> str | None:
    """Returns the newest lesson of the class whose present title this is."""
    rows = db.execute(
        "SELECT id, title FROM lessons WHERE classroom_id = ? ORDER BY opened_at DESC, id DESC",
        [classroom_id],
    )
    title_key = name_key(title)
    return next((str(row["id"]) for row in rows if name_key(row["title"]) == title_key), None)


def _free_key(db: sqlite3.Connection, classroom_id: str, title: str) -> str:
    """Returns the key that every PC makes from class and title.

    If the lesson with this key was deleted, or has another title now, returns the next one of the same sequence.
    """
    key = uuid.uuid5(uuid.UUID(classroom_id), name_key(title))
    in_use = (
        "SELECT id FROM tombstones WHERE id = :key UNION SELECT id FROM lessons WHERE id = :key"
    )
    while db.execute(in_use, {"key": str(key)}).fetchone():
        key = uuid.uuid5(key, "again")
    return str(key)


def _close(db: sqlite3.Connection, lesson_id: str, now: str) -> None:
    """Closes a lesson without raising its revision, as lessons also close by themselves.

    A greater revision would win over a title that the teacher gives meanwhile on another PC.
    """
    query = "UPDATE lessons SET closed_at = ? WHERE id = ? AND closed_at IS NULL"
    db.execute(query, [now, lesson_id])


def _joinable(db: sqlite3.Connection, lesson_id: str, to: str) -> str:
    """Returns the root of the tree that the lesson can be joined to."""
    rows = db.execute("SELECT id, classroom_id FROM lessons WHERE id IN (?, ?)", [lesson_id, to])
    lessons = {row["id"]: row["classroom_id"] for row in rows}
    if len(lessons) < 2:
        missing = to if lesson_id in lessons and to != lesson_id else lesson_id
        code = "lesson_not_joinable" if to == lesson_id else "lesson_not_found"
        raise StoreError(code, id=missing)
    root = tree_of(db, to)[0]
    if root == lesson_id or lessons[lesson_id] != lessons[to]:
        raise StoreError("lesson_not_joinable", id=lesson_id)
    return root


def _lesson_row(row: sqlite3.Row, by_part: Mapping[str, str]) -> LessonRow:
    shown = {"by_itself": bool(row["by_itself"]), "part_of": by_part.get(row["id"])}
    return LessonRow(**{**dict(row), **shown})
