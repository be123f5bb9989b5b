"""Programs of a group; their content are versions."""

import sqlite3

from storage.connection import Access
from storage.errors import StoreError
from storage.groups import touch
from storage.records import ProgramRow
from storage.text import clean_name, new_id

_SELECT = """
    SELECT id, name, group_id, created_at, updated_at, deleted_at,
           (SELECT count(*) FROM versions WHERE program_id = programs.id) AS n_versions,
           (SELECT count(*) FROM runs WHERE program_id = programs.id) AS n_runs
    FROM programs"""


class Programs:
    """The programs of the file."""

    def __init__(self, access: Access) -> None:
        self._access = access

    def of_group(self, group_id: str, *, in_bin: bool = False) -> list[ProgramRow]:
        """Newest first; with `in_bin` those that were thrown away. Raises StoreError `group_not_found`."""
        which = "deleted_at IS NOT NULL" if in_bin else "deleted_at IS NULL"
        with self._access.reading() as db:
            require_group(db, group_id)
            rows = db.execute(
                f"{_SELECT} WHERE group_id = ? AND {which} ORDER BY id DESC", [group_id]
            ).fetchall()
        return [ProgramRow(**dict(row)) for row in rows]

    def get(self, program_id: str) -> ProgramRow:
        """Raises StoreError `program_not_found`."""
        with self._access.reading() as db:
            row = db.execute(f"{_SELECT} WHERE id = ?", [program_id]).fetchone()
        if row is None:
            raise StoreError("program_not_found", id=program_id)
        return ProgramRow(**dict(row))

    def create(self, group_id: str, name: str) -> ProgramRow:
        """Raises StoreError `group_not_found`, `name_empty` or `name_too_long`."""
        clean, now = clean_name(name), self._access.now()

        def insert(db: sqlite3.Connection) -> str:
            require_group(db, group_id)
            program_id = new_id()
            db.execute(
                """INSERT INTO programs (id, group_id, name, created_at, updated_at, changed_at)
                   VALUES (?, ?, ?, ?, ?, ?)""",
                [program_id, group_id, clean, now, now, now],
            )
            touch(db, group_id, now)
            return program_id

        return self.get(self._access.write(insert))

    def rename(self, program_id: str, name: str) -> ProgramRow:
        """Raises StoreError `program_not_found`, `name_empty` or `name_too_long`."""
        return self._change(program_id, "name", clean_name(name))

    def throw_away(self, program_id: str) -> ProgramRow:
        """Puts it into the bin, with all its versions and runs. Raises StoreError `program_not_found`."""
        return self._change(program_id, "deleted_at", self._access.now())

    def take_back(self, program_id: str) -> ProgramRow:
        """Takes it out of the bin. Raises StoreError `program_not_found`."""
        return self._change(program_id, "deleted_at", None)

    def _change(self, program_id: str, column: str, value: str | None) -> ProgramRow:
        now = self._access.now()
        self._access.write(
            lambda db: (
                db.execute(
                    f"UPDATE programs SET {column} = ?, revision = revision + 1, changed_at = ? WHERE id = ?",
                    [value, now, program_id],
                ).rowcount
            )
        )
        return self.get(program_id)


def require_group(db: sqlite3.Connection, group_id: str) -> None:
    """Raises StoreError `group_not_found`."""
    if db.execute("SELECT 1 FROM groups WHERE id = ?", [group_id]).fetchone() is None:
        raise StoreError("group_not_found", id=group_id)
