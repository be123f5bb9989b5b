"""A bundle as Parquet files, one a table, for the statistics of a district; the columns are in docs/parquet.md.

pyarrow is large and only here: a school that wants this installs it itself.
"""

import shutil
import sqlite3
from collections.abc import Iterator
from contextlib import closing, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from storage.content import tuples
from storage.errors import StoreError

if TYPE_CHECKING:
    import pyarrow as pa

_ROWS = 10_000
# table -> (column, type, what it is worked out from). Types: text, count, number, flag, time.
TABLES: dict[str, tuple[tuple[str, str, str], ...]] = {
    "computers": (("id", "text", "id"), ("name", "text", "name")),
    "classrooms": (
        ("id", "text", "id"),
        ("name", "text", "name"),
        ("created_at", "time", "created_at"),
    ),
    "groups": (
        ("id", "text", "id"),
        ("classroom_id", "text", "classroom_id"),
        ("name", "text", "name"),
        ("created_at", "time", "created_at"),
        ("used_at", "time", "used_at"),
    ),
    "lessons": (
        ("id", "text", "id"),
        ("classroom_id", "text", "classroom_id"),
        ("computer_id", "text", "computer_id"),
        ("title", "text", "title"),
        ("activity", "text", "activity"),
        ("by_itself", "flag", "by_itself"),
        ("part_of", "text", "part_of"),
        ("opened_at", "time", "opened_at"),
        ("closed_at", "time", "closed_at"),
    ),
    "programs": (
        ("id", "text", "id"),
        ("group_id", "text", "group_id"),
        ("name", "text", "name"),
        ("created_at", "time", "created_at"),
        ("updated_at", "time", "updated_at"),
        ("deleted_at", "time", "deleted_at"),
    ),
    "versions": (
        ("id", "text", "id"),
        ("program_id", "text", "program_id"),
        ("parent_id", "text", "parent_id"),
        ("lesson_id", "text", "lesson_id"),
        ("computer_id", "text", "computer_id"),
        ("number", "count", "number"),
        ("created_at", "time", "created_at"),
        ("document", "text", "document"),
        ("n_faults", "count", "json_array_length(faults)"),
    ),
    "runs": (
        ("id", "text", "id"),
        ("group_id", "text", "group_id"),
        ("program_id", "text", "program_id"),
        ("version_id", "text", "version_id"),
        ("lesson_id", "text", "lesson_id"),
        ("computer_id", "text", "computer_id"),
        ("link", "text", "link"),
        ("world", "text", "world"),
        ("activity", "text", "activity"),
        ("passed", "flag", "passed"),
        ("state", "text", "state"),
        ("reason", "text", "reason"),
        ("started_at", "time", "started_at"),
        ("ended_at", "time", "ended_at"),
        ("duration_s", "number", "duration_s"),
        ("n_executed", "count", "n_executed"),
        ("path_length_m", "number", "path_length_m"),
        ("closing_error_m", "number", "closing_error_m"),
        ("app_version", "text", "app_version"),
        ("n_events", "count", "(SELECT count(*) FROM events WHERE run_id = runs.id)"),
        (
            "n_samples",
            "count",
            "(SELECT coalesce(sum(n_rows), 0) FROM telemetry WHERE run_id = runs.id)",
        ),
    ),
}


def write_parquet(bundle: Path, dest: Path) -> Path:
    """Writes a folder with a file TABLE.parquet for each of `TABLES`; it is there only when it is whole.

    Args:
        bundle: a bundle that this release wrote.
        dest: the folder; where there is one already, the new one gets a number.

    Raises:
        StoreError: `parquet_missing` without pyarrow; `export_failed`.
    """
    try:
        import pyarrow  # noqa: F401, PLC0415 - see above
    except ImportError:
        raise StoreError("parquet_missing") from None
    part = dest.with_name(f".{dest.name}.part")
    try:
        shutil.rmtree(part, ignore_errors=True)
        part.mkdir()
        with closing(sqlite3.connect(f"{bundle.absolute().as_uri()}?mode=ro", uri=True)) as db:
            for table in TABLES:
                _write_table(db, table, part / f"{table}.parquet")
        return part.rename(_free_name(dest))
    except OSError as error:
        problem = error.strerror or str(error)
        raise StoreError("export_failed", path=str(dest), problem=problem) from error
    finally:
        with suppress(OSError):
            shutil.rmtree(part, ignore_errors=True)


def _write_table(db: sqlite3.Connection, table: str, path: Path) -> None:
    import pyarrow as pa  # noqa: PLC0415
    import pyarrow.parquet as pq  # noqa: PLC0415

    schema = pa.schema([(name, _type(kind)) for name, kind, _ in TABLES[table]])
    with pq.ParquetWriter(path, schema, compression="zstd") as writer:
        for rows in _batches(db, table):
            values = zip(*rows, strict=True)
            columns = [
                _column(list(column), kind)
                for column, (_, kind, _) in zip(values, TABLES[table], strict=True)
            ]
            writer.write_table(pa.table(columns, schema=schema))


def _batches(db: sqlite3.Connection, table: str) -> Iterator[list[tuple[Any, ...]]]:
    sources = ", ".join(source for _, _, source in TABLES[table])
    cursor = tuples(db, f"SELECT {sources} FROM {table} ORDER BY id")
    while rows := cursor.fetchmany(_ROWS):
        yield rows


def _type(kind: str) -> "pa.DataType":
    import pyarrow as pa  # noqa: PLC0415

    return {
        "text": pa.string(),
        "count": pa.int64(),
        "number": pa.float64(),
        "flag": pa.bool_(),
        "time": pa.timestamp("us", tz="UTC"),
    }[kind]


def _column(values: list[Any], kind: str) -> "pa.Array":
    import pyarrow as pa  # noqa: PLC0415

    if kind == "flag":
        values = [None if value is None else bool(value) for value in values]
    if kind == "time":
        return pa.array([value or None for value in values], pa.string()).cast(_type(kind))
    return pa.array(values, _type(kind))


def _free_name(dest: Path) -> Path:
    path, n = dest, 1
    while path.exists():
        n += 1
        path = dest.with_name(f"{dest.name}-{n}")
    return path
