"""Programs of a group; their content is in versions."""

from storage.file.repository import Repository
from storage.row_types import ProgramRow
from storage.sql import insert, require, rows_of, selected, setup_value, update_row
from storage.sqlite import sqlite3
from storage.text import clean_name, new_id
from storage.work.groups import record_use

_SELECT = selected(
    ProgramRow,
    "programs",
    n_versions="SELECT count(*) FROM versions WHERE program_id = programs.id",
    n_runs="SELECT count(*) FROM runs WHERE program_id = programs.id",
)
# by id, not by time: the clocks of school PCs are often wrong
_LAST_CHANGED_FIRST = """ORDER BY
    coalesce((SELECT max(id) FROM versions WHERE program_id = programs.id), programs.id) DESC"""
_ACTIVITY = f"""(SELECT {setup_value("setup", "activity")} FROM versions
    WHERE program_id = programs.id ORDER BY number DESC, id DESC LIMIT 1)"""


class Programs(Repository):
    """The programs of the file."""

    def of_group(self, group_id: str, *, in_bin: bool = False) -> list[ProgramRow]:
        """Returns the programs of a group, the one changed last first; with `in_bin` the ones in the bin.

        Raises:
            StoreError: `group_not_found`.
        """
        which = "deleted_at IS NOT NULL" if in_bin else "deleted_at IS NULL"
        query = f"{_SELECT} WHERE group_id = ? AND {which} {_LAST_CHANGED_FIRST}"
        with self._database.read_connection() as db:
            require(db, "groups", group_id)
            return [ProgramRow(**dict(row)) for row in rows_of(db, query, [group_id])]

    def of_activity(self, group_id: str, activity: str) -> ProgramRow | None:
        """Returns the group's program for an activity that was changed last; none in the bin.

        Raises:
            StoreError: `group_not_found`.
        """
        query = f"""{_SELECT} WHERE group_id = ? AND deleted_at IS NULL AND {_ACTIVITY} = ?
            {_LAST_CHANGED_FIRST} LIMIT 1"""
        with self._database.read_connection() as db:
            require(db, "groups", group_id)
            rows = rows_of(db, query, [group_id, activity])
        return ProgramRow(**dict(rows[0])) if rows else None

    def get(self, program_id: str) -> ProgramRow:
        """Returns a program. Raises StoreError `program_not_found`."""
        return ProgramRow(**dict(self._row("programs", f"{_SELECT} WHERE id = ?", program_id)))

    def create(self, group_id: str, name: str) -> ProgramRow:
        """Adds a program. Raises StoreError `group_not_found`, `name_empty` or `name_too_long`."""
        clean, now = clean_name(name), self._database.now()
        row = {"id": new_id(), "group_id": group_id, "name": clean}
        row |= dict.fromkeys(("created_at", "updated_at", "changed_at"), now)

        def write(db: sqlite3.Connection) -> None:
            require(db, "groups", group_id)
            insert(db, "programs", row)
            record_use(db, group_id, now)

        self._database.write(write)
        return self.get(row["id"])

    def rename(self, program_id: str, name: str) -> ProgramRow:
        """Renames a program. Raises StoreError `program_not_found`, `name_empty` or `name_too_long`."""
        return self._change(program_id, "name", clean_name(name))

    def move_to_bin(self, program_id: str) -> ProgramRow:
        """Moves a program to the bin with its versions and runs. Raises StoreError `program_not_found`."""
        return self._change(program_id, "deleted_at", self._database.now())

    def restore_from_bin(self, program_id: str) -> ProgramRow:
        """Takes a program out of the bin. Raises StoreError `program_not_found`."""
        return self._change(program_id, "deleted_at", None)

    def _change(self, program_id: str, column: str, value: str | None) -> ProgramRow:
        now = self._database.now()
        self._database.write(
            lambda db: update_row(db, "programs", program_id, {column: value}, now)
        )
        return self.get(program_id)
