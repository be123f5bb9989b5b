"""Writes a bundle as Parquet files, one for each table, for the statistics of a district (docs/parquet.md: columns).

pyarrow is large and only this module uses it, so a school that wants Parquet files installs it.
"""

import shutil
from collections.abc import Iterable, Iterator, Sequence
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
    require_pyarrow()
    part = dest.with_name(f".{dest.name}.part")
    try:
        shutil.rmtree(part, ignore_errors=True)
        part.mkdir()
        with closing(opened(bundle, "ro")) as db:
            for table, declared in FILES.items():
                columns = [(column.name, column.type) for column in declared]
                write_columns(part / f"{table}.parquet", columns, _batches(db, table))
        return part.rename(free_path(dest, suffix=""))
    except OSError as error:
        problem = error.strerror or str(error)
        raise StoreError("export_failed", path=str(dest), problem=problem) from error
    finally:
        with suppress(OSError):
            shutil.rmtree(part, ignore_errors=True)


def require_pyarrow() -> None:
    """Raises StoreError `parquet_missing` without pyarrow."""
    try:
        import pyarrow  # noqa: F401, PLC0415 - optional
    except ImportError:
        raise StoreError("parquet_missing") from None


def write_columns(
    path: Path, columns: Sequence[tuple[str, str]], batches: Iterable[Sequence[Sequence[Any]]]
) -> None:
    """Writes one Parquet file.

    Args:
        columns: name and type (docs/parquet.md) of each column.
        batches: rows, of which each batch is a row group; none of them is empty.
    """
    import pyarrow as pa  # noqa: PLC0415
    import pyarrow.parquet as pq  # noqa: PLC0415

    schema = pa.schema([(name, _type(kind)) for name, kind in columns])
    with pq.ParquetWriter(path, schema, compression="zstd") as writer:
        for rows in batches:
            values = zip(*rows, strict=True)
            arrays = [
                _array(list(column), kind)
                for column, (_, kind) in zip(values, columns, strict=True)
            ]
            writer.write_table(pa.table(arrays, schema=schema))


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
