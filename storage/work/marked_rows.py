"""Rows that a deletion only marks, because lessons, runs and versions refer to their keys."""

from typing import ClassVar, Generic, TypeVar

from storage.errors import StoreError
from storage.file.repository import Repository
from storage.row_types import CalibratedRobotRow, OwnActivityRow
from storage.sql import row_count, selected, update_row
from storage.sqlite import sqlite3
from storage.text import readable_object

Row = TypeVar("Row", OwnActivityRow, CalibratedRobotRow)


class MarkedRows(Repository, Generic[Row]):
    """Reads the rows of one table, deletes and restores them.

    Attributes:
        most: how many rows there may be, deleted ones not counted.
        json_columns: columns with a JSON object.
    """

    table: ClassVar[str]
    most: ClassVar[int]
    json_columns: ClassVar[tuple[str, ...]]
    row_type: type[Row]

    def all(self) -> list[Row]:
        """Returns the rows that are not deleted, oldest first."""
        return [self._read(row) for row in self._rows(self._select("deleted_at IS NULL"))]

    def get(self, key: str) -> Row:
        """Returns a row, also a deleted one. Raises StoreError `KIND_not_found`."""
        return self._read(self._row(self.table, self._select("id = ?"), key))

    def delete(self, key: str) -> None:
        """Deletes it from all lists. Raises StoreError `KIND_not_found`."""
        self._set_deleted_at(key, self._database.now())

    def undelete(self, key: str) -> None:
        """Undoes `delete`. Raises StoreError `KIND_not_found`."""
        self._set_deleted_at(key, None)

    def _set_deleted_at(self, key: str, deleted_at: str | None) -> None:
        before, now = self.get(key), self._database.now()
        if (before.deleted_at is None) != (deleted_at is None):
            values = {"deleted_at": deleted_at}
            self._database.write(lambda db: update_row(db, self.table, key, values, now))

    def _require_room(self, db: sqlite3.Connection) -> None:
        if row_count(db, self.table, "deleted_at IS NULL") >= self.most:
            raise StoreError(f"{self.table}_too_many", max=self.most)

    def _select(self, condition: str) -> str:
        return f"{selected(self.row_type, self.table)} WHERE {condition} ORDER BY id"

    def _read(self, row: sqlite3.Row) -> Row:
        parsed = {name: readable_object(row[name]) or {} for name in self.json_columns}
        return self.row_type(**{**dict(row), **parsed})
