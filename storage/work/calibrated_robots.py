"""Robots of the simulator with the errors of a real one. A deleted one is only marked, as versions refer to its key."""

from collections.abc import Mapping
from typing import Any

from storage.limits import MAX_CALIBRATED_ROBOTS
from storage.row_types import CalibratedRobotRow
from storage.sql import insert
from storage.sqlite import sqlite3
from storage.text import clean_name, new_id, to_json
from storage.work.marked_rows import MarkedRows


class CalibratedRobots(MarkedRows[CalibratedRobotRow]):
    """The calibrated robots of the file."""

    table, row_type, most = "calibrated_robots", CalibratedRobotRow, MAX_CALIBRATED_ROBOTS
    json_columns = ("parameters", "report")

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
            self._require_room(db)
            insert(db, self.table, row)

        self._database.write(write)
        return self.get(key)
