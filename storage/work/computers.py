"""This PC, by a key and a name: what is made here can be told from what was made elsewhere.

Beside the key stands a mark of the machine. Where it is that of another one, the folder was copied here: the copy gets
a key of its own, and the old key stays with what was made before.
"""

import platform
import sqlite3

from storage import machine
from storage.connection import Access
from storage.errors import StoreError
from storage.settings import keep, kept
from storage.text import MAX_NAME, clean_name, new_id

_KEY, _MARK = "computer_id", "machine_mark"


class Computers:
    """This PC's key and name."""

    def __init__(self, access: Access) -> None:
        self._access = access

    def here(self) -> tuple[str, str]:
        """Key and name of this PC; made when first asked for. Raises StoreError where they cannot be kept."""
        with self._access.reading() as db:
            found = known(db)
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
    found = known(db)
    if found is not None:
        if kept(db, _MARK) is None:  # made by an earlier release
            keep(db, _MARK, machine.machine_mark())
        return found
    key, name = new_id(), _name_of_system()
    keep(db, _KEY, key)
    keep(db, _MARK, machine.machine_mark())
    db.execute("INSERT INTO computers (id, name, changed_at) VALUES (?, ?, ?)", [key, name, now])
    return key, name


def _name_of_system() -> str:
    """As the network knows the PC: up to 64 letters, of which a name here has fewer."""
    try:
        return clean_name(platform.node()[:MAX_NAME])
    except StoreError:
        return "PC"


def known(db: sqlite3.Connection) -> tuple[str, str] | None:
    """Key and name of this PC, None where it has none in this file yet."""
    key, mark, here = kept(db, _KEY), kept(db, _MARK), machine.machine_mark()
    if key is None or (mark and here and mark != here):
        return None
    named = db.execute("SELECT name FROM computers WHERE id = ?", [key]).fetchone()
    return None if named is None else (key, str(named["name"]))
