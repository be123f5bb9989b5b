"""Classes of the school."""

from storage.errors import StoreError
from storage.file.repository import Repository
from storage.row_types import ClassroomRow
from storage.sql import insert, require, selected, update_row
from storage.sqlite import sqlite3
from storage.text import clean_name, name_key, natural_key, new_id

_SELECT = selected(
    ClassroomRow,
    "classrooms",
    computer="""SELECT computers.name FROM lessons JOIN computers ON computers.id = lessons.computer_id
        WHERE lessons.classroom_id = classrooms.id ORDER BY opened_at, lessons.id LIMIT 1""",
    n_groups="SELECT count(*) FROM groups WHERE classroom_id = classrooms.id",
)


class Classrooms(Repository):
    """The classes of the file."""

    def all(self) -> list[ClassroomRow]:
        """Returns all classes by name, with numbers in names ordered by value: 1º, 2º, 10º."""
        return sorted((ClassroomRow(**dict(row)) for row in self._rows(_SELECT)), key=_order)

    def get(self, classroom_id: str) -> ClassroomRow:
        """Returns a class. Raises StoreError `classroom_not_found`."""
        return ClassroomRow(
            **dict(self._row("classrooms", f"{_SELECT} WHERE id = ?", classroom_id))
        )

    def create(self, name: str, key: str | None = None) -> ClassroomRow:
        """Adds a class. Raises StoreError `classroom_exists`, `name_empty` or `name_too_long`.

        Args:
            key: its key, if several PCs make the same class.
        """
        clean, now = clean_name(name), self._database.now()
        row = {"id": key or new_id(), "name": clean, "created_at": now, "changed_at": now}

        def write(db: sqlite3.Connection) -> None:
            _require_free(db, clean, "")
            insert(db, "classrooms", row)

        self._database.write(write)
        return self.get(row["id"])

    def rename(self, classroom_id: str, name: str) -> ClassroomRow:
        """Renames a class.

        Raises:
            StoreError: `classroom_not_found`, `classroom_exists`, `name_empty` or `name_too_long`.
        """
        clean, now = clean_name(name), self._database.now()

        def write(db: sqlite3.Connection) -> None:
            require(db, "classrooms", classroom_id)
            _require_free(db, clean, classroom_id)
            update_row(db, "classrooms", classroom_id, {"name": clean}, now)

        self._database.write(write)
        return self.get(classroom_id)


def _order(row: ClassroomRow) -> tuple[list[str | int], str]:
    """Returns the sort key; classes of the same name are ordered by key."""
    return natural_key(row.name), row.id


def _require_free(db: sqlite3.Connection, name: str, own_id: str) -> None:
    for row in db.execute("SELECT id, name FROM classrooms"):
        if name_key(row["name"]) == name_key(name) and row["id"] != own_id:
            raise StoreError("classroom_exists", name=row["name"])
