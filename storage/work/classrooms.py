"""Classes of the school."""

import re
import sqlite3

from storage.connection import Access
from storage.errors import StoreError
from storage.records import ClassroomRow
from storage.text import clean_name, name_key, new_id

_NUMBERS = re.compile(r"([0-9]+)")
_SELECT = """
    SELECT id, name, created_at,
           (SELECT computers.name FROM lessons JOIN computers ON computers.id = lessons.computer_id
            WHERE lessons.classroom_id = classrooms.id ORDER BY opened_at, lessons.id LIMIT 1) AS computer,
           (SELECT count(*) FROM groups WHERE classroom_id = classrooms.id) AS n_groups
    FROM classrooms"""


class Classrooms:
    """The classes of the file."""

    def __init__(self, access: Access) -> None:
        self._access = access

    def all(self) -> list[ClassroomRow]:
        """By name, numbers in it by their value: 1º, 2º, 10º."""
        with self._access.reading() as db:
            rows = db.execute(_SELECT).fetchall()
        return sorted((ClassroomRow(**dict(row)) for row in rows), key=_place)

    def get(self, classroom_id: str) -> ClassroomRow:
        """Raises StoreError `classroom_not_found`."""
        with self._access.reading() as db:
            row = db.execute(f"{_SELECT} WHERE id = ?", [classroom_id]).fetchone()
        if row is None:
            raise StoreError("classroom_not_found", id=classroom_id)
        return ClassroomRow(**dict(row))

    def create(self, name: str) -> ClassroomRow:
        """Raises StoreError `classroom_exists`, `name_empty` or `name_too_long`."""
        clean, now = clean_name(name), self._access.now()

        def insert(db: sqlite3.Connection) -> str:
            _require_free(db, clean, "")
            classroom_id = new_id()
            db.execute(
                "INSERT INTO classrooms (id, name, created_at, changed_at) VALUES (?, ?, ?, ?)",
                [classroom_id, clean, now, now],
            )
            return classroom_id

        return self.get(self._access.write(insert))

    def rename(self, classroom_id: str, name: str) -> ClassroomRow:
        """Raises StoreError `classroom_not_found`, `classroom_exists`, `name_empty` or `name_too_long`."""
        clean, now = clean_name(name), self._access.now()

        def change(db: sqlite3.Connection) -> None:
            require_classroom(db, classroom_id)
            _require_free(db, clean, classroom_id)
            db.execute(
                "UPDATE classrooms SET name = ?, revision = revision + 1, changed_at = ? WHERE id = ?",
                [clean, now, classroom_id],
            )

        self._access.write(change)
        return self.get(classroom_id)


def _place(row: ClassroomRow) -> tuple[list[str | int], str]:
    """Texts and numbers take turns; classes of one name stay in their order."""
    parts = _NUMBERS.split(name_key(row.name))
    return [int(part) if n % 2 else part for n, part in enumerate(parts)], row.id


def require_classroom(db: sqlite3.Connection, classroom_id: str) -> None:
    """Raises StoreError `classroom_not_found`."""
    if db.execute("SELECT 1 FROM classrooms WHERE id = ?", [classroom_id]).fetchone() is None:
        raise StoreError("classroom_not_found", id=classroom_id)


def _require_free(db: sqlite3.Connection, name: str, own_id: str) -> None:
    for row in db.execute("SELECT id, name FROM classrooms"):
        if name_key(row["name"]) == name_key(name) and row["id"] != own_id:
            raise StoreError("classroom_exists", name=row["name"])
