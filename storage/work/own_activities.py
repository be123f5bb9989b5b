"""Activities that a teacher made. A deleted one is only marked, because lessons, runs and programs refer to its key."""

from collections.abc import Mapping
from typing import Any

from storage.errors import StoreError
from storage.file.repository import Repository
from storage.limits import MAX_OWN_ACTIVITIES
from storage.row_types import OwnActivityRow
from storage.sql import insert, row_count, rows_of, selected, update_row
from storage.sqlite import sqlite3
from storage.text import clean_name, new_id, readable_object, to_json

_SELECT = selected(OwnActivityRow, "own_activities")


class OwnActivities(Repository):
    """The activities of the file that a teacher made."""

    def all(self) -> list[OwnActivityRow]:
        """Returns the activities that are not deleted, oldest first."""
        with self._database.read_connection() as db:
            rows = rows_of(db, f"{_SELECT} WHERE deleted_at IS NULL ORDER BY id")
        return [_activity_row(row) for row in rows]

    def titles(self, *, with_deleted: bool = True) -> dict[str, str]:
        """Returns titles by key, oldest first."""
        which = "" if with_deleted else "WHERE deleted_at IS NULL"
        rows = self._rows(f"SELECT id, title FROM own_activities {which} ORDER BY id")
        return {str(row["id"]): str(row["title"]) for row in rows}

    def get(self, activity_id: str) -> OwnActivityRow:
        """Returns an activity, also a deleted one. Raises StoreError `own_activity_not_found`."""
        with self._database.read_connection() as db:
            rows = rows_of(db, f"{_SELECT} WHERE id = ?", [activity_id])
        if not rows:
            raise StoreError("own_activity_not_found", id=activity_id)
        return _activity_row(rows[0])

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
            known = db.execute("SELECT 1 FROM own_activities WHERE id = ?", [activity_id])
            if known.fetchone():
                update_row(db, "own_activities", activity_id, values, now)
                return
            if row_count(db, "own_activities", "deleted_at IS NULL") >= MAX_OWN_ACTIVITIES:
                raise StoreError("own_activities_too_many", max=MAX_OWN_ACTIVITIES)
            made = {"id": activity_id, "created_at": now, "changed_at": now}
            insert(db, "own_activities", {**made, **values})

        self._database.write(write)
        return self.get(activity_id)

    def delete(self, activity_id: str) -> None:
        """Deletes it from all lists. Raises StoreError `own_activity_not_found`."""
        self._set_deleted_at(activity_id, self._database.now())

    def undelete(self, activity_id: str) -> None:
        """Undoes `delete`. Raises StoreError `own_activity_not_found`."""
        self._set_deleted_at(activity_id, None)

    def _set_deleted_at(self, activity_id: str, deleted_at: str | None) -> None:
        before, now = self.get(activity_id), self._database.now()
        if (before.deleted_at is None) != (deleted_at is None):
            values = {"deleted_at": deleted_at}
            self._database.write(
                lambda db: update_row(db, "own_activities", activity_id, values, now)
            )


def _activity_row(row: sqlite3.Row) -> OwnActivityRow:
    values = dict(row)
    parsed = {name: readable_object(values[name]) or {} for name in ("document", "goal")}
    return OwnActivityRow(**{**values, **parsed})
