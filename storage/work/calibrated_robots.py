"""Robots of the simulator with the errors of a real one. A deleted one is only marked, as versions refer to its key."""

from collections.abc import Mapping
from typing import Any

from storage.errors import StoreError
from storage.file.repository import Repository
from storage.limits import MAX_CALIBRATED_ROBOTS
from storage.row_types import CalibratedRobotRow
from storage.sql import insert, row_count, rows_of, selected, update_row
from storage.sqlite import sqlite3
from storage.text import clean_name, new_id, readable_object, to_json

_TABLE = "calibrated_robots"
_SELECT = selected(CalibratedRobotRow, _TABLE)


class CalibratedRobots(Repository):
    """The calibrated robots of the file."""

    def all(self) -> list[CalibratedRobotRow]:
        """Returns the robots that are not deleted, oldest first."""
        with self._database.read_connection() as db:
            rows = rows_of(db, f"{_SELECT} WHERE deleted_at IS NULL ORDER BY id")
        return [_robot_row(row) for row in rows]

    def get(self, robot_id: str) -> CalibratedRobotRow:
        """Returns a robot, also a deleted one. Raises StoreError `calibrated_robot_not_found`."""
        with self._database.read_connection() as db:
            rows = rows_of(db, f"{_SELECT} WHERE id = ?", [robot_id])
        if not rows:
            raise StoreError("calibrated_robot_not_found", id=robot_id)
        return _robot_row(rows[0])

    def create(
        self, title: str, model: str, parameters: Mapping[str, float], report: Mapping[str, Any]
    ) -> CalibratedRobotRow:
        """Adds a robot. Raises StoreError `name_empty`, `name_too_long`, `calibrated_robots_too_many`."""
        now, key = self._database.now(), new_id()
        row = {
            "id": key,
            "title": clean_name(title),
            "model": model,
            "parameters": to_json(parameters),
            "report": to_json(report),
            "created_at": now,
            "changed_at": now,
        }

        def write(db: sqlite3.Connection) -> None:
            if row_count(db, _TABLE, "deleted_at IS NULL") >= MAX_CALIBRATED_ROBOTS:
                raise StoreError("calibrated_robots_too_many", max=MAX_CALIBRATED_ROBOTS)
            insert(db, _TABLE, row)

        self._database.write(write)
        return self.get(key)

    def delete(self, robot_id: str) -> None:
        """Deletes it from all lists. Raises StoreError `calibrated_robot_not_found`."""
        self._set_deleted_at(robot_id, self._database.now())

    def undelete(self, robot_id: str) -> None:
        """Undoes `delete`. Raises StoreError `calibrated_robot_not_found`."""
        self._set_deleted_at(robot_id, None)

    def _set_deleted_at(self, robot_id: str, deleted_at: str | None) -> None:
        before, now = self.get(robot_id), self._database.now()
        if (before.deleted_at is None) != (deleted_at is None):
            values = {"deleted_at": deleted_at}
            self._database.write(lambda db: update_row(db, _TABLE, robot_id, values, now))


def _robot_row(row: sqlite3.Row) -> CalibratedRobotRow:
    values = dict(row)
    parsed = {name: readable_object(values[name]) or {} for name in ("parameters", "report")}
    return CalibratedRobotRow(**{**values, **parsed})
