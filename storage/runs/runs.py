"""Runs: creates, records and ends them, and reads them back.

Telemetry needs numpy, which takes longer to load than the rest of the store, so it is imported when first used.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from storage.errors import StoreError
from storage.file.connection import Timestamp
from storage.file.repository import Repository
from storage.row_types import SIMULATOR, Json, RunRow, RunStart, RunSummary
from storage.run_validity import confirmation_status, counted, masking_damage
from storage.sql import insert, not_found, require, rows_of, selected
from storage.sqlite import sqlite3
from storage.text import new_id, readable_object, readable_points, to_json
from storage.work.groups import record_use
from storage.work.lessons import lesson_for

if TYPE_CHECKING:
    from storage.runs.telemetry import Telemetry

_SELECT = selected(RunRow, "runs", unconfirmed=confirmation_status())
_SUMMARY = selected(
    RunSummary,
    "runs",
    state=masking_damage("state"),
    reason=masking_damage("reason"),
    params_json=masking_damage("params"),
    passed_bit=counted(),
    path_json="path",
    summary_json="summary",
    parameters_json="parameters",
    unconfirmed=confirmation_status(),
)
_OBJECTS = ("document", "world_document", "parameters", "params", "summary", "check_report")
_NEEDED = ("world_document", "parameters")
_IN_COLUMNS = ("v", "type", "run", "seq", "tick")
_METRICS = ("n_executed", "path_length_m", "closing_error_m", "telemetry_sha256")
_AT_END = ("state", "reason", "block", "duration_s", *_METRICS)


@dataclass(slots=True, eq=False)
class Batch:
    """The part of a run that is written in one transaction.

    Attributes:
        chunks: (chunk, first tick, rows, blob) of telemetry.
        ended: the `run_ended` event, None before the end.
        path: points for the picture, in m; used with `ended`.
        at: when it happened, which may be long before it can be written.
    """

    run_id: str
    at: str
    events: list[Mapping[str, Any]] = field(default_factory=list)
    chunks: list[tuple[int, int, int, bytes]] = field(default_factory=list)
    ended: Mapping[str, Any] | None = None
    path: list[list[float]] = field(default_factory=list)


class Runs(Repository):
    """The runs of the file."""

    def begin(self, start: RunStart) -> RunRow:
        """Records that a run starts; on disk when this returns. Raises StoreError `version_not_found`."""
        now = self._database.timestamp()
        return self.get(self._database.write(lambda db: _insert(db, start, now)))

    def discard(self, run_id: str) -> None:
        """Deletes a run that could not start."""
        self._database.write(
            lambda db: db.execute("DELETE FROM runs WHERE id = ?", [run_id]).rowcount
        )

    def update_document(self, run_id: str, document: Json) -> None:
        """Replaces the document of a live run that has no version; on disk when this returns."""
        self._database.write(
            lambda db: (
                db.execute(
                    "UPDATE runs SET document = ? WHERE id = ? AND version_id IS NULL",
                    [to_json(document), run_id],
                ).rowcount
            )
        )

    def attach_version(self, run_id: str, version_id: str) -> None:
        """Records that a version has the run's document."""
        self._database.write(
            lambda db: (
                db.execute(
                    "UPDATE runs SET version_id = ?, document = NULL WHERE id = ?",
                    [version_id, run_id],
                ).rowcount
            )
        )

    def get(self, run_id: str) -> RunRow:
        """Returns a run. Raises StoreError `run_not_found`, `run_damaged`."""
        self._require_intact("runs", run_id)
        return _run_row(self._row("runs", f"{_SELECT} WHERE id = ?", run_id))

    def of_group(
        self, group_id: str, *, before: str | None = None, limit: int = 50
    ) -> list[RunSummary]:
        """Returns a page of runs, newest first, without their damaged values.

        Args:
            before: id of the last run of the previous page.
        """
        query = f"{_SUMMARY} WHERE group_id = ? AND id < ? ORDER BY id DESC LIMIT ?"
        return [RunSummary._make(row) for row in self._rows(query, group_id, before or "~", limit)]

    def newest(self, limit: int) -> list[RunRow]:
        """Returns the newest runs of all groups and of none, newest first, without their damaged values."""
        rows = self._rows(f"{_SELECT} ORDER BY id DESC LIMIT ?", limit)
        return [_run_row(row, lenient=True) for row in rows]

    def newest_real(self, limit: int) -> list[RunRow]:
        """Returns the newest ended runs on real robots, newest first, without their damaged values."""
        real = f"link IS NOT '{SIMULATOR}' AND state IS NOT 'running'"
        rows = self._rows(f"{_SELECT} WHERE {real} ORDER BY id DESC LIMIT ?", limit)
        return [_run_row(row, lenient=True) for row in rows]

    def ids_beginning_with(self, prefix: str) -> list[str]:
        """Returns ids that begin with what a person typed; at most 10."""
        query = "SELECT id FROM runs WHERE substr(id, 1, ?) = ? ORDER BY id DESC LIMIT 10"
        return [str(row["id"]) for row in self._rows(query, len(prefix), prefix)]

    def ids(self) -> list[str]:
        """Returns the ids of all runs, oldest first."""
        return [str(row["id"]) for row in self._rows("SELECT id FROM runs ORDER BY id")]

    def events(self, run_id: str) -> list[Json]:
        """Returns all events but telemetry, as they were on the wire.

        Raises:
            StoreError: `run_not_found`, `run_damaged`.
        """
        self._require_intact("events", run_id)
        with self._database.read_connection() as db:
            require(db, "runs", run_id)
            rows = rows_of(
                db,
                "SELECT seq, tick, type, data FROM events WHERE run_id = ? ORDER BY seq",
                [run_id],
            )
        return [_event(run_id, row) for row in rows]

    def telemetry(self, run_id: str) -> "Telemetry":
        """Returns all samples of a run. Raises StoreError `run_not_found`, `run_damaged`."""
        self._require_intact("telemetry", run_id)
        with self._database.read_connection() as db:
            require(db, "runs", run_id)
            return _telemetry(db, run_id)

    def _require_intact(self, part: str, run_id: str) -> None:
        if not self._is_intact(part, run_id):
            raise StoreError("run_damaged", id=run_id, part=part)

    def running(self) -> list[str]:
        """Returns the ids of the runs that have not ended."""
        with self._database.read_connection() as db:
            return _running(db)

    def close_interrupted(self) -> int:
        """Ends every run that is still `running`, after its program was killed. Returns their number."""
        now = self._database.now()

        def close_all(db: sqlite3.Connection) -> int:
            run_ids = _running(db)
            close_runs(db, run_ids, now)
            return len(run_ids)

        return self._database.write(close_all)


def close_runs(db: sqlite3.Connection, run_ids: Sequence[str], now: str) -> None:
    """Ends the given runs that have not ended, within the caller's transaction."""
    for run_id in set(run_ids).intersection(_running(db)):
        write_batch(db, _interrupted(db, run_id, now))


def write_batch(db: sqlite3.Connection, batch: Batch) -> None:
    """Writes a batch within the caller's transaction; writing it again changes nothing."""
    db.executemany(
        "INSERT OR REPLACE INTO events (run_id, seq, tick, type, data) VALUES (?, ?, ?, ?, ?)",
        [
            [batch.run_id, event["seq"], event["tick"], event["type"], to_json(_rest(event))]
            for event in batch.events
        ],
    )
    db.executemany(
        "INSERT OR REPLACE INTO telemetry (run_id, chunk, first_tick, n_rows, data) VALUES (?, ?, ?, ?, ?)",
        [[batch.run_id, *chunk] for chunk in batch.chunks],
    )
    if batch.ended is not None:
        _end(db, batch.run_id, batch.ended, batch.path, batch.at)


def _end(
    db: sqlite3.Connection,
    run_id: str,
    ended: Mapping[str, Any],
    path: Sequence[Sequence[float]],
    at: str,
) -> None:
    changes = {name: ended.get(name) for name in _AT_END}
    changes |= {"params": to_json(ended.get("params") or {}), "summary": to_json(_rest(ended))}
    changes |= {"path": to_json(path), "ended_at": at}
    assignments = ", ".join(f"{name} = :{name}" for name in changes)
    db.execute(f"UPDATE runs SET {assignments} WHERE id = :id", {**changes, "id": run_id})


def _insert(db: sqlite3.Connection, start: RunStart, now: Timestamp) -> str:
    origin = _origin(db, start)
    row = {
        "id": new_id(),
        **origin,
        "version_id": start.version_id,
        "document": None if start.document is None else to_json(start.document),
        "link": start.link,
        "world": start.world,
        "world_document": to_json(start.world_document),
        "seed": start.seed,
        "parameters": to_json(start.parameters),
        "app_version": start.app_version,
        "state": "running",
        "started_at": now.text,
        "activity": start.activity,
    }
    if origin["group_id"]:
        row["lesson_id"], row["computer_id"] = lesson_for(db, origin["group_id"], now)
        row["activity"] = row["activity"] or _activity_of(db, str(row["lesson_id"]))
    insert(db, "runs", row)
    if origin["group_id"]:
        record_use(db, origin["group_id"], now.text)
    return str(row["id"])


def _origin(db: sqlite3.Connection, start: RunStart) -> dict[str, str | None]:
    """Returns group and program of a version; for a run of the command line only the name in its document."""
    version_id = start.version_id
    if version_id is None and start.program_id is not None:
        return _origin_of_program(db, start.program_id)
    if version_id is None:
        name = (start.document or {}).get("name")
        return {"group_id": None, "program_id": None, "program_name": str(name) if name else None}
    row = db.execute(
        """SELECT programs.group_id, programs.id AS program_id, programs.name AS program_name
           FROM versions JOIN programs ON programs.id = versions.program_id WHERE versions.id = ?""",
        [version_id],
    ).fetchone()
    if row is None:
        raise not_found("versions", version_id)
    return dict(row)


def _origin_of_program(db: sqlite3.Connection, program_id: str) -> dict[str, str | None]:
    row = db.execute(
        "SELECT group_id, id AS program_id, name AS program_name FROM programs WHERE id = ?",
        [program_id],
    ).fetchone()
    if row is None:
        raise not_found("programs", program_id)
    return dict(row)


def _activity_of(db: sqlite3.Connection, lesson_id: str) -> str | None:
    row = db.execute("SELECT activity FROM lessons WHERE id = ?", [lesson_id]).fetchone()
    return None if row["activity"] is None else str(row["activity"])


def _running(db: sqlite3.Connection) -> list[str]:
    return [str(row["id"]) for row in db.execute("SELECT id FROM runs WHERE state = 'running'")]


def _interrupted(db: sqlite3.Connection, run_id: str, now: str) -> Batch:
    """Returns the end of an interrupted run, computed from its recorded events and samples."""
    from storage.runs.simplify_path import outline  # noqa: PLC0415 - needs numpy
    from storage.runs.telemetry import RATE_HZ  # noqa: PLC0415

    rows = _telemetry(db, run_id)
    ticks, points = rows.column("tick"), rows.rows[:, 1:3]
    last = db.execute(
        "SELECT coalesce(max(seq), -1) AS seq, coalesce(max(tick), 0) AS tick FROM events WHERE run_id = ?",
        [run_id],
    ).fetchone()
    tick = max(int(last["tick"]), int(ticks[-1]) if len(ticks) else 0)
    ended = {
        **dict.fromkeys(("block", "pose", *_METRICS)),
        "type": "run_ended",
        "seq": last["seq"] + 1 + len(ticks),
        "tick": tick,
        "state": "failed",
        "reason": "interrupted",
        "params": {},
        "duration_s": tick / RATE_HZ,
    }
    return Batch(run_id, now, events=[ended], ended=ended, path=outline(points))


def _telemetry(db: sqlite3.Connection, run_id: str) -> "Telemetry":
    from storage.runs.telemetry import joined  # noqa: PLC0415 - needs numpy

    rows = db.execute(
        "SELECT data, n_rows FROM telemetry WHERE run_id = ? ORDER BY chunk", [run_id]
    )
    try:
        return joined([(row["data"], row["n_rows"]) for row in rows])
    except (ValueError, TypeError) as error:
        raise StoreError("run_damaged", id=run_id, part="telemetry") from error


def _rest(event: Mapping[str, Any]) -> Json:
    return {name: value for name, value in event.items() if name not in _IN_COLUMNS}


def _event(run_id: str, row: sqlite3.Row) -> Json:
    head = {"v": 1, "type": row["type"], "run": run_id, "seq": row["seq"], "tick": row["tick"]}
    if not isinstance(row["tick"], int):
        raise StoreError("run_damaged", id=run_id, part="events")
    return {**head, **(_object(row["data"], run_id, "events") or {})}


def _run_row(row: sqlite3.Row, *, lenient: bool = False) -> RunRow:
    """Returns the row. `lenient`, for lists, leaves damaged values empty."""
    values = dict(row)
    for name in _OBJECTS:
        text = values[name]
        values[name] = readable_object(text) if lenient else _object(text, row["id"], name)
    missing = next((name for name in _NEEDED if values[name] is None), None)
    if missing and not lenient:
        raise StoreError("run_damaged", id=row["id"], part=missing)
    values |= {name: values[name] or {} for name in (*_NEEDED, "params", "summary")}
    values |= {
        "path": readable_points(values["path"]),
        "passed": None if values["passed"] is None else bool(values["passed"]),
    }
    return RunRow(**values)


def _object(text: Any, run_id: str, part: str) -> Json | None:
    """Returns a JSON object, None for NULL. Raises StoreError `run_damaged`."""
    value = readable_object(text)
    if value is None and text not in (None, "null"):
        raise StoreError("run_damaged", id=run_id, part=part)
    return value
