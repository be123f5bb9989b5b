"""Where real robots truly were in their runs, by source of truth. What a row means: pinel_desktop/runs/truth.py."""

import uuid
from collections.abc import Sequence

from storage.errors import StoreError
from storage.file.repository import Repository
from storage.row_types import TruePoseRow, TruthRow
from storage.sql import exists, insert, require, update_row
from storage.sqlite import sqlite3
from storage.tables.rules import poses as accepts_poses
from storage.text import readable, to_json

_DECIMALS = (4, 4, 5, 5, 5)  # a tenth of a millimetre, less than a thousandth of a degree
_OF_RUN = (
    "SELECT source, measured_at, poses FROM truths WHERE run_id = ? ORDER BY source, revision, id"
)


class Truths(Repository):
    """The truths of the file."""

    def of_run(self, run_id: str) -> list[TruthRow]:
        """Returns the truths of a run by source, without those taken back and those that are damaged."""
        found: dict[str, TruthRow] = {}
        for row in self._rows(_OF_RUN, run_id):
            found.pop(row["source"], None)
            if row["poses"] != "[]" and accepts_poses(row["poses"]):
                poses = tuple(tuple(pose) for pose in readable(row["poses"]))
                found[row["source"]] = TruthRow(run_id, row["source"], row["measured_at"], poses)
        return list(found.values())

    def record(self, run_id: str, source: str, poses: Sequence[TruePoseRow]) -> None:
        """Replaces what a source says about a run; no poses take it back.

        Raises:
            StoreError: `run_not_found`; `truth_invalid` if a pose breaks a rule, or the poses are not in their order.
        """
        text = to_json([_rounded(pose) for pose in poses])
        if not accepts_poses(text):
            raise StoreError("truth_invalid")
        key, now = str(uuid.uuid5(uuid.UUID(run_id), source)), self._database.now()
        values = {"poses": text, "measured_at": now}

        def write(db: sqlite3.Connection) -> None:
            require(db, "runs", run_id)
            if exists(db, "truths", key):
                update_row(db, "truths", key, values, now)
            else:
                row = {"id": key, "run_id": run_id, "source": source, **values, "changed_at": now}
                insert(db, "truths", row)

        self._database.write(write)


def _rounded(pose: TruePoseRow) -> list[float | None]:
    tick, *values = pose
    return [tick, *(round(value, n) for value, n in zip(values, _DECIMALS, strict=True))]
