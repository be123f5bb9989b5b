"""Settings and other values of this PC; they are not replicated."""

from typing import Any

from storage.file.repository import Repository
from storage.sql import rows_of
from storage.sqlite import sqlite3
from storage.text import readable, to_json


class Settings(Repository):
    """Values by name, as JSON."""

    def get(self, key: str) -> Any:
        """Returns the value, None if none was set."""
        with self._database.read_connection() as db:
            return read_setting(db, key)

    def set(self, key: str, value: object) -> None:
        """Sets the value; on disk when this returns."""
        self._database.write(lambda db: write_setting(db, key, value))


def read_setting(db: sqlite3.Connection, key: str) -> Any:
    """Returns the value of that name, None if there is none or it cannot be read."""
    found = rows_of(db, "SELECT value FROM settings WHERE key = ?", [key])
    return readable(found[0]["value"]) if found else None


def write_setting(db: sqlite3.Connection, key: str, value: object) -> None:
    """Sets the value of that name, within the caller's transaction."""
    db.execute("INSERT OR REPLACE INTO settings VALUES (?, ?)", [key, to_json(value)])
