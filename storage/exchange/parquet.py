"""Writes a bundle as Parquet files, one for each table, for the statistics of a district (docs/parquet.md: columns).

pyarrow is large and only this module uses it, so a school that wants Parquet files installs it.
"""

import shutil
from collections.abc import Iterator
from contextlib import closing, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from storage.errors import StoreError
from storage.file.atomic_files import free_path
from storage.sql import opened, tuples
from storage.sqlite import sqlite3
from storage.tables.replicated import REPLICATED

if TYPE_CHECKING:
    import pyarrow as pa

_ROWS = 10_000
# the columns of the files, by table
FILES = {table.name: table.parquet_columns for table in REPLICATED if table.parquet}


def write_parquet(bundle: Path, dest: Path) -> Path:
    """Writes a folder with a file TABLE.parquet for each of `FILES`; it appears when it is complete.

    Args:
        bundle: a bundle that this release wrote.
        dest: the folder. If it exists, the new one gets a number.

    Raises:
        StoreError: `parquet_missing` without pyarrow; `export_failed`.
    """
    try:
        import pyarrow  # noqa: F401, PLC0415 - optional
    except ImportError:
        raise StoreError("parquet_missing") from None
    part = dest.with_name(f".{dest.name}.part")
    try:
        shutil.rmtree(part, ignore_errors=True)
        part.mkdir()
        with closing(opened(bundle, "ro")) as db:
            for table in FILES:
                _write_table(db, table, part / f"{table}.parquet")
        return part.rename(free_path(dest, suffix=""))
    except OSError as error:
        problem = error.strerror or str(error)
        raise StoreError("export_failed", path=str(dest), problem=problem) from error
    finally:
        with suppress(OSError):
            shutil.rmtree(part, ignore_errors=True)


def _write_table(db: sqlite3.Connection, table: str, path: Path) -> None:
    import pyarrow as pa  # noqa: PLC0415
    import pyarrow.parquet as pq  # noqa: PLC0415

    kinds = [column.type for column in FILES[table]]
    schema = pa.schema([(column.name, _type(column.type)) for column in FILES[table]])
    with pq.ParquetWriter(path, schema, compression="zstd") as writer:
        for rows in _batches(db, table):
            values = zip(*rows, strict=True)
            columns = [
                _array(list(column), kind) for column, kind in zip(values, kinds, strict=True)
            ]
            writer.write_table(pa.table(columns, schema=schema))


def _batches(db: sqlite3.Connection, table: str) -> Iterator[list[tuple[Any, ...]]]:
    sources = ", ".join(column.source for column in FILES[table])
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


def _array(values: list[Any], kind: str) -> "pa.Array":
    import pyarrow as pa  # noqa: PLC0415

    if kind == "flag":
        values = [None if value is None else bool(value) for value in values]
    if kind == "time":
        return pa.array([value or None for value in values], pa.string()).cast(_type(kind))
    return pa.array(values, _type(kind))
