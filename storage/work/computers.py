"""This PC's key and name, which distinguish its work from the work of other PCs.

Hashes of the ids of machine and hardware are stored with the key. If they are those of another PC, the data folder, or
the whole disk, was copied to this one. This PC then gets a key of its own, and earlier work stays under the old key.
"""

import platform
from typing import Any

from storage.errors import StoreError
from storage.file.repository import Repository
from storage.limits import MAX_NAME
from storage.sql import insert, rows_of, update_row
from storage.sqlite import sqlite3
from storage.text import clean_name, new_id
from storage.work import machine
from storage.work.hardware import Hardware, is_other_hardware
from storage.work.settings import read_setting, write_setting

_KEY, _MACHINE, _HARDWARE = "computer_id", "machine_mark", "hardware_marks"


class Computers(Repository):
    """This PC's key and name."""

    def this(self) -> tuple[str, str]:
        """Returns key and name of this PC, made on the first call. Raises StoreError if they cannot be stored."""
        with self._database.read_connection() as db:
            found = find_computer(db)
        if found is not None:
            return found
        now = self._database.now()
        return self._database.write(lambda db: this_computer(db, now))

    def is_this(self, computer_id: str | None) -> bool:
        """Returns whether the key is that of this PC."""
        with self._database.read_connection() as db:
            found = find_computer(db)
        return found is not None and found[0] == computer_id

    def name_of_other(self, computer_id: str | None) -> str | None:
        """Returns the name of a PC if it is known and not this one."""
        found = self._rows("SELECT name FROM computers WHERE id = ?", computer_id)
        return None if not found or self.is_this(computer_id) else str(found[0]["name"])

    def rename(self, name: str) -> str:
        """Renames this PC. Raises StoreError `name_empty` or `name_too_long`."""
        clean, now = clean_name(name), self._database.now()

        def write(db: sqlite3.Connection) -> None:
            key, before = this_computer(db, now)
            if clean != before:
                update_row(db, "computers", key, {"name": clean}, now)

        self._database.write(write)
        return clean


def this_computer(db: sqlite3.Connection, now: str) -> tuple[str, str]:
    """Returns key and name of this PC; makes them if there are none, within the caller's transaction."""
    found = find_computer(db)
    if found is not None:
        _update_machine(db)
        return found
    key, name = new_id(), _name_of_system()
    write_setting(db, _KEY, key)
    write_setting(db, _MACHINE, machine.machine_id_hash())
    write_setting(db, _HARDWARE, machine.hardware_hashes())
    insert(db, "computers", {"id": key, "name": name, "changed_at": now})
    return key, name


def find_computer(db: sqlite3.Connection) -> tuple[str, str] | None:
    """Returns key and name of this PC, None if it has none in this file yet."""
    key = read_setting(db, _KEY)
    if key is None or _is_other_pc(db):
        return None
    named = rows_of(db, "SELECT name FROM computers WHERE id = ?", [key])
    return (key, str(named[0]["name"])) if named else None


def _is_other_pc(db: sqlite3.Connection) -> bool:
    """Returns whether the key was made on another PC, as far as both can be told apart."""
    stored_machine, this = read_setting(db, _MACHINE), machine.machine_id_hash()
    if stored_machine and this and stored_machine != this:
        return True
    return is_other_hardware(_as_hardware(read_setting(db, _HARDWARE)), machine.hardware_hashes())


def _as_hardware(stored: Any) -> Hardware:
    """Returns the stored hashes; none where an earlier release stored none."""
    pairs = stored.items() if isinstance(stored, dict) else ()
    return {str(kind): ids for kind, ids in pairs if isinstance(ids, list)}


def _update_machine(db: sqlite3.Connection) -> None:
    """Stores what an earlier release did not, and hardware that was replaced or added."""
    if read_setting(db, _MACHINE) is None:
        write_setting(db, _MACHINE, machine.machine_id_hash())
    stored, found = _as_hardware(read_setting(db, _HARDWARE)), machine.hardware_hashes()
    if stored | found != stored:
        write_setting(db, _HARDWARE, stored | found)


def _name_of_system() -> str:
    """Returns the PC's network name, cut to `MAX_NAME` characters, as it can have 64."""
    try:
        return clean_name(platform.node()[:MAX_NAME])
    except StoreError:
        return "PC"
