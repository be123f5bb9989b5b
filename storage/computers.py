"""This PC, by a key and a name: what is made here can be told from what was made elsewhere."""

import platform
import sqlite3

from storage.connection import Access
from storage.text import clean_name, dumped, loaded, new_id

_KEY = "computer_id"


class Computers:
    """This PC's key and name."""

    def __init__(self, access: Access) -> None:
        self._access = access

    def here(self) -> tuple[str, str]:
        """Key and name of this PC; made when first asked for. Raises StoreError where they cannot be kept."""
        with self._access.reading() as db:
            found = _known(db)
        if found is not None:
            return found
        now = self._access.now()
        return self._access.write(lambda db: here(db, now))

    def rename(self, name: str) -> str:
        """Gives this PC a name that people know it by. Raises StoreError `name_empty` or `name_too_long`."""
        clean, now = clean_name(name), self._access.now()

        def change(db: sqlite3.Connection) -> None:
            key, _ = here(db, now)
            db.execute(
                "UPDATE computers SET name = ?, revision = revision + 1, changed_at = ? WHERE id = ? AND name != ?",
                [clean, now, key, clean],
            )

        self._access.write(change)
        return clean


def here(db: sqlite3.Connection, now: str) -> tuple[str, str]:
    """Key and name of this PC, made where there are none, within the caller's transaction."""
    found = _known(db)
    if found is not None:
        return found
    key, name = new_id(), clean_name(platform.node() or "PC")
    db.execute("INSERT OR REPLACE INTO settings VALUES (?, ?)", [_KEY, dumped(key)])
    db.execute("INSERT INTO computers (id, name, changed_at) VALUES (?, ?, ?)", [key, name, now])
    return key, name


def _known(db: sqlite3.Connection) -> tuple[str, str] | None:
    row = db.execute("SELECT value FROM settings WHERE key = ?", [_KEY]).fetchone()
    if row is None:
        return None
    key = str(loaded(row["value"]))
    named = db.execute("SELECT name FROM computers WHERE id = ?", [key]).fetchone()
    return None if named is None else (key, str(named["name"]))
