"""Anonymises a bundle: deletes names and texts, and replaces keys.

Unchanged: the commands of programs with their numbers; runs with path, samples, outcome and times; the order of rows.
Replaced by a number: names of groups, classes, lessons, programs and PCs. Deleted: notes, labels, comments, the
editor's workspaces. Replaced by neutral words: texts and names in programs, and people's answers. All keys are new.
Each column declares how it is anonymised (`storage/tables/`). Who has the original file can still find a run by its
samples; docs/bundles.md warns teachers.
"""

import re
from collections.abc import Callable, Collection
from typing import Any

from storage.sqlite import sqlite3
from storage.tables.columns import KEY, UNCHANGED, Column, ReplicatedTable
from storage.tables.replicated import REPLICATED
from storage.text import from_json, name_key, new_id, to_json

# values under these keys are terms of the language or of the robot, not texts of pupils
_UNCHANGED_KEYS = {
    *("action", "op", "sensor", "direction", "symbol", "color", "state", "cause"),
    *(
        "reason",
        "source",
        "pace",
        "preset",
        "feedback",
        "model",
        "check",
        "code",
        "type",
        "mode",
        "by",
    ),
}
# under "gesture", an expression names what it reads of a sign; an event has the sign, whose name a class may have given
_GESTURE_READINGS = ("result", "number")
# under these keys, the keys of the object are names that pupils gave
_NAMING = ("arguments", "variables")
_OWN = "own"  # the name of every world that a group made
_POINTER = re.compile(r"(/(functions|commands|elif|else|\d+))*")
_TABLES = tuple(table for table in REPLICATED if table.anonymous)


def anonymising(known: Collection[str]) -> Callable[[sqlite3.Connection], None]:
    """Returns the function that deletes names and texts from a bundle before it is finished.

    Args:
        known: names and texts of worlds and activities that ship, which identify no group.
    """
    return lambda db: _Anonymising(db, frozenset(known)).work()


class _Anonymising:
    def __init__(self, db: sqlite3.Connection, known: frozenset[str]) -> None:
        self._db = db
        self._known = known | {_OWN}
        self._keys: dict[str, str] = {}
        self._texts: dict[str, str] = {}

    def work(self) -> None:
        self._db.create_function("fresh", 1, self._keys.get)
        self._db.create_function("neutral", 1, self._neutral_json)
        self._db.create_function("plain", 1, self._plain)
        self._db.create_function("name_key", 1, name_key)
        self._db.execute("BEGIN")
        for table in REPLICATED:
            if not table.anonymous:
                self._db.execute(f"DELETE FROM {table.name}")
        # first all other columns: the numbers that replace names follow the order of the old keys
        for table in _TABLES:
            self._replace(table, [column for column in table.columns if column.kind is not KEY])
        self._make_keys()
        for table in _TABLES:
            self._replace(table, _keys_of(table))
        self._db.execute("COMMIT")
        self._db.execute("VACUUM")  # otherwise free pages would still hold the texts

    def _replace(self, table: ReplicatedTable, columns: list[Column]) -> None:
        replaced = [
            f"{one.name} = {one.anonymous}" for one in columns if one.anonymous != UNCHANGED
        ]
        if replaced:
            self._db.execute(f"UPDATE {table.name} SET {', '.join(replaced)}")

    def _make_keys(self) -> None:
        """Makes new keys in the order of the old ones, because lists are sorted by key."""
        old: set[str] = set()
        for table in _TABLES:
            for column in _keys_of(table):
                rows = self._db.execute(f"SELECT DISTINCT {column.name} FROM {table.name}")
                old.update(key for (key,) in rows if key)
        self._keys.update((key, new_id()) for key in sorted(old))

    def _neutral_json(self, text: str | None) -> str | None:
        return None if text is None else to_json(self._neutral(from_json(text), ""))

    def _neutral(self, value: Any, key: str) -> Any:
        if isinstance(value, dict):
            names = key in _NAMING
            return {
                (self._plain(name) if names else name): self._neutral(part, "" if names else name)
                for name, part in value.items()
                if name != "comment"
            }
        if isinstance(value, list):
            return [self._neutral(part, key) for part in value]
        if not isinstance(value, str) or key in _UNCHANGED_KEYS:
            return value
        if key == "gesture" and value in _GESTURE_READINGS:
            return value
        if key == "pointer":
            return value if _POINTER.fullmatch(value) else ""
        return self._plain(value)

    def _plain(self, text: str | None) -> str | None:
        """Returns the same replacement for the same text, so that one variable stays one variable.

        A single character is unchanged: it is a letter of LIBRAS, or X or O.
        """
        if text is None or len(text) <= 1 or text in self._known:
            return text
        return self._texts.setdefault(text, f"t{len(self._texts) + 1}")


def _keys_of(table: ReplicatedTable) -> list[Column]:
    return [column for column in table.columns if column.kind is KEY]
