"""The base class of the repositories of groups, lessons, programs, runs and so on."""

from storage.file.connection import Database
from storage.file.row_checksums import is_intact
from storage.sql import not_found, rows_of, snapshot
from storage.sqlite import sqlite3


class Repository:
    """Reads rows of one kind; repairs damaged ones."""

    def __init__(self, database: Database) -> None:
        self._database = database

    def _rows(self, query: str, *values: object) -> list[sqlite3.Row]:
        with self._database.read_connection() as db:
            return rows_of(db, query, values)

    def _is_intact(self, table: str, key: str) -> bool:
        """Returns whether the row is intact (`row_checksums`); repairs a damaged one if a backup has it intact."""
        with self._database.read_connection() as db:
            if is_intact(db, table, key):
                return True
        return self._try_repair(table, key)

    def _intact_row(self, table: str, query: str, key: str) -> sqlite3.Row | None:
        """Returns the first row, None if it is damaged. One snapshot serves the check and the query.

        Raises:
            StoreError: `KIND_not_found`.
        """
        with self._database.read_connection() as db, snapshot(db):
            if is_intact(db, table, key):
                return _first(rows_of(db, query, [key]), table, key)
        return self._row(table, query, key) if self._try_repair(table, key) else None

    def _try_repair(self, table: str, key: str) -> bool:
        from storage.file.row_repair import try_repair  # noqa: PLC0415 - rarely needed

        return try_repair(self._database, table, key)

    def _row(self, table: str, query: str, key: str) -> sqlite3.Row:
        """Returns the first row. Raises StoreError `KIND_not_found`; the kind is the table's name in the singular."""
        return _first(self._rows(query, key), table, key)


def _first(rows: list[sqlite3.Row], table: str, key: str) -> sqlite3.Row:
    if not rows:
        raise not_found(table, key)
    return rows[0]
