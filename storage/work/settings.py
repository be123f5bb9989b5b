"""What a person chose, and what is known on this PC alone: neither goes to others."""

import sqlite3
from typing import Any

from storage.connection import Access
from storage.text import dumped, loaded


class Settings:
    """Values by name, as JSON."""

    def __init__(self, access: Access) -> None:
        self._access = access

    def get(self, key: str) -> Any:
        """None where nothing was chosen."""
        with self._access.reading() as db:
            return kept(db, key)

    def set(self, key: str, value: object) -> None:
        """On disk when this returns."""
        self._access.write(lambda db: keep(db, key, value))


def kept(db: sqlite3.Connection, key: str) -> Any:
    """The value of that name, None where there is none."""
    row = db.execute("SELECT value FROM settings WHERE key = ?", [key]).fetchone()
    return loaded(row["value"]) if row else None


def keep(db: sqlite3.Connection, key: str, value: object) -> None:
    """Gives the name a value, within the caller's transaction."""
    db.execute("INSERT OR REPLACE INTO settings VALUES (?, ?)", [key, dumped(value)])
