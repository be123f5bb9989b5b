"""Class presets: the settings that the groups of a class start with. One row for each class, made when first set."""

from collections.abc import Mapping
from typing import Any, Literal

from storage.file.repository import Repository
from storage.sql import exists, insert, require, rows_of, update_row
from storage.sqlite import sqlite3
from storage.text import readable_object, to_json

# levels of the toolbox
LEVELS = (1, 2, 3)
# between reminders to swap roles; 0 for none
SwapMinutes = Literal[0, 5, 10, 15]


class ClassPresets(Repository):
    """The presets of the classes."""

    def get(self, classroom_id: str) -> dict[str, Any]:
        """Returns the preset, empty if none was set. Raises StoreError `classroom_not_found`."""
        with self._database.read_connection() as db:
            require(db, "classrooms", classroom_id)
            query = "SELECT preset FROM class_presets WHERE id = ?"
            found = rows_of(db, query, [classroom_id])
        return (readable_object(found[0]["preset"]) or {}) if found else {}

    def set(self, classroom_id: str, preset: Mapping[str, Any]) -> None:
        """Sets the preset; does nothing if it is the present one. Raises StoreError `classroom_not_found`."""
        now, preset_json = self._database.now(), to_json(dict(preset))
        if self.get(classroom_id) == dict(preset):
            return

        def write(db: sqlite3.Connection) -> None:
            require(db, "classrooms", classroom_id)
            if exists(db, "class_presets", classroom_id):
                update_row(db, "class_presets", classroom_id, {"preset": preset_json}, now)
            else:
                insert(
                    db,
                    "class_presets",
                    {"id": classroom_id, "preset": preset_json, "changed_at": now},
                )

        self._database.write(write)
