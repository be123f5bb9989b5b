"""A bundle without names and texts: what was done stays, who did it and in which words does not.

Stays: what programs do and their numbers, runs with path, samples, outcome and times, the order of everything.
Goes: names of groups, classes, lessons, programs and PCs (a number in their place), notes, labels, comments, all
that is said, asked, answered or named in programs, the blocks as they lay in the editor. Keys are new ones. Whoever
has the original file can still find a run by its samples: docs/bundles.md says so to teachers.
"""

import re
import sqlite3
from collections.abc import Callable, Collection
from typing import Any

from storage.content import CONTENT, columns
from storage.text import dumped, loaded, name_key, new_id

# words of the language and of the robot under these keys are nobody's own
_KEPT = {
    *(
        "action",
        "op",
        "sensor",
        "direction",
        "gesture",
        "symbol",
        "color",
        "state",
        "cause",
        "reason",
    ),
    *("source", "pace", "preset", "feedback", "model", "check", "code", "type", "mode"),
}
# names are keys of these
_NAMING = ("arguments", "variables")
_OWN = "own"  # the name of every world that a group has made
_POINTER = re.compile(r"(/(functions|commands|elif|else|\d+))*")
_KEY_COLUMNS = {
    *("id", "group_id", "classroom_id", "program_id", "version_id", "lesson_id", "computer_id"),
    *("run_id", "parent_id", "part_of"),
}
_JSON = {
    "versions": ("document", "world"),
    "runs": ("document", "parameters", "params", "summary", "check_report"),
    "events": ("data",),
}
_NUMBERED = {
    "classrooms": ("name", "Turma"),
    "groups": ("name", "Grupo"),
    "programs": ("name", "Programa"),
    "computers": ("name", "PC"),
}


def anonymising(known: Collection[str]) -> Callable[[sqlite3.Connection], None]:
    """What takes names and texts out of a bundle before it is finished.

    Args:
        known: names and texts of worlds and activities that ship, which tell nothing of a group.
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
        self._db.create_function("key_of", 1, name_key)
        self._db.execute("BEGIN")
        for table in ("tombstones", "notes", "version_labels"):
            self._db.execute(f"DELETE FROM {table}")
        self._replace_names()
        self._replace_texts()
        self._replace_keys()
        self._db.execute("COMMIT")
        self._db.execute("VACUUM")  # or the texts would still lie in pages that are free now

    def _replace_names(self) -> None:
        for table, (column, word) in _NUMBERED.items():
            place = f"(SELECT count(*) FROM {table} AS other WHERE other.id <= {table}.id)"
            self._db.execute(f"UPDATE {table} SET {column} = '{word} ' || {place}")
        self._db.execute("UPDATE groups SET name_key = key_of(name)")
        self._db.execute(
            """UPDATE lessons SET activity = plain(activity), title = CASE title WHEN '' THEN '' ELSE 'Aula ' ||
               (SELECT count(*) FROM lessons AS other WHERE other.id <= lessons.id) END"""
        )
        self._db.execute(
            """UPDATE runs SET program_name = CASE WHEN program_name IS NULL THEN NULL ELSE
               coalesce((SELECT name FROM programs WHERE programs.id = program_id), 'Programa') END"""
        )

    def _replace_texts(self) -> None:
        for table, names in _JSON.items():
            assignments = ", ".join(f"{name} = neutral({name})" for name in names)
            self._db.execute(f"UPDATE {table} SET {assignments}")
        self._db.execute(
            """UPDATE versions SET workspace = '{}', faults =
               CASE faults WHEN '[]' THEN '[]' ELSE '[["anonymous","",null,{}]]' END"""
        )
        self._db.execute(
            """UPDATE runs SET world = plain(world), activity = plain(activity), block = plain(block),
               world_document = neutral(world_document)"""
        )

    def _replace_keys(self) -> None:
        """New keys in the order of the old ones, which lists go by."""
        tables = [content.table for content in CONTENT]
        places = [
            (table, column)
            for table in tables
            for column in columns(self._db, table)
            if column in _KEY_COLUMNS
        ]
        old: set[str] = set()
        for table, column in places:
            rows = self._db.execute(f"SELECT DISTINCT {column} FROM {table}")
            old.update(row[0] for row in rows if row[0])
        self._keys.update((key, new_id()) for key in sorted(old))
        for table in tables:
            assignments = [
                f"{column} = fresh({column})" for name, column in places if name == table
            ]
            self._db.execute(f"UPDATE {table} SET {', '.join(assignments)}")

    def _neutral_json(self, text: str | None) -> str | None:
        return None if text is None else dumped(self._neutral(loaded(text), ""))

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
        if not isinstance(value, str) or key in _KEPT:
            return value
        if key == "pointer":
            return value if _POINTER.fullmatch(value) else ""
        return self._plain(value)

    def _plain(self, text: str | None) -> str | None:
        """The same for the same text: a variable stays one. A single sign is a letter of LIBRAS or a mark."""
        if text is None or len(text) <= 1 or text in self._known:
            return text
        return self._texts.setdefault(text, f"t{len(self._texts) + 1}")
