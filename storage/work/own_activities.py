"""Activities that a teacher made. A deleted one is only marked, because lessons, runs and programs refer to its key."""

from collections.abc import Mapping
from typing import Any

from storage.limits import MAX_OWN_ACTIVITIES
from storage.row_types import OwnActivityRow
from storage.sql import exists, insert, update_row
from storage.sqlite import sqlite3
from storage.text import clean_name, new_id, to_json
from storage.work.marked_rows import MarkedRows


class OwnActivities(MarkedRows[OwnActivityRow]):
    """The activities of the file that a teacher made."""

    table, row_type, most = "own_activities", OwnActivityRow, MAX_OWN_ACTIVITIES
    json_columns = ("document", "goal")

    def titles(self, *, with_deleted: bool = True) -> dict[str, str]:
        """Returns titles by key, oldest first."""
        which = "" if with_deleted else "WHERE deleted_at IS NULL"
        rows = self._rows(f"SELECT id, title FROM own_activities {which} ORDER BY id")
        return {str(row["id"]): str(row["title"]) for row in rows}

    def new_key(self) -> str:
        """Returns the key for a new activity, whose document must have it."""
        return new_id()

    def save(
        self, activity_id: str, title: str, document: Mapping[str, Any], goal: Mapping[str, Any]
    ) -> OwnActivityRow:
        """Adds an activity, or replaces the content of the one with that key, which is then no longer deleted.

        Raises:
            StoreError: `name_empty`, `name_too_long`; `own_activities_too_many`.
        """
        now = self._database.now()
        values: dict[str, object] = {"title": clean_name(title), "deleted_at": None}
        values |= {"document": to_json(document), "goal": to_json(goal)}

        def write(db: sqlite3.Connection) -> None:
            if exists(db, self.table, activity_id):
                update_row(db, self.table, activity_id, values, now)
                return
            self._require_room(db)
            made = {"id": activity_id, "created_at": now, "changed_at": now}
            insert(db, self.table, {**made, **values})

        self._database.write(write)
        return self.get(activity_id)
