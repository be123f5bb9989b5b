"""The table of a sweep: one line for each run, as CSV or Parquet, in a fixed order."""

import csv
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice
from pathlib import Path
from typing import Any

from pinel_desktop.commands.batch.journal import unwritable
from pinel_desktop.errors import PinelError
from pinel_desktop.sweep import Row
from pinel_desktop.sweep.variation import ParameterRange
from storage.exchange.parquet import require_pyarrow, write_columns
from storage.file.atomic_files import atomic_write

ENDINGS = (".csv", ".parquet")
_LINES = 10_000  # of a row group
# name and type (docs/parquet.md) of the columns before and after those of varied parameters
_BEFORE = (("program", "text"), ("world", "text"), ("seed", "count"))
_AFTER = (
    ("state", "text"),
    ("reason", "text"),
    ("passed", "flag"),
    ("cause", "text"),
    ("check", "text"),
    ("n_collisions", "count"),
    ("closing_error_m", "number"),
    ("duration_s", "number"),
    ("telemetry_sha256", "text"),
)


def require_new_table(path: Path) -> None:
    """Raises PinelError `sweep_ending`, `sweep_exists`; StoreError `parquet_missing`."""
    if path.suffix.lower() not in ENDINGS:
        raise PinelError("sweep_ending", path=str(path), allowed=list(ENDINGS))
    if path.exists():
        raise PinelError("sweep_exists", path=str(path))
    if path.suffix.lower() == ".parquet":
        require_pyarrow()


def write_table(path: Path, rows: Iterable[Row], ranges: Sequence[ParameterRange]) -> None:
    """Writes the table; it appears when it is complete. Raises PinelError `sweep_unwritable`."""
    columns = [*_BEFORE, *((one.name, "number") for one in ranges), *_AFTER]
    in_order = sorted(rows, key=lambda row: row.index)
    lines = (_values(row, ranges) for row in in_order)
    try:
        with atomic_write(path) as part:
            if path.suffix.lower() == ".parquet":
                write_columns(part, columns, _batches(lines))
            else:
                _write_csv(part, [name for name, _ in columns], lines)
    except OSError as error:
        raise unwritable(path, error) from error


def _values(row: Row, ranges: Sequence[ParameterRange]) -> list[Any]:
    return [
        *(getattr(row, name) for name, _ in _BEFORE),
        *(one.value(row.seed) for one in ranges),
        *(getattr(row, name) for name, _ in _AFTER),
    ]


def _batches(lines: Iterator[list[Any]]) -> Iterator[list[list[Any]]]:
    while batch := list(islice(lines, _LINES)):
        yield batch


def _write_csv(path: Path, names: Sequence[str], lines: Iterable[Sequence[Any]]) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(names)
        writer.writerows([_as_text(value) for value in line] for line in lines)


def _as_text(value: Any) -> Any:
    return str(value).lower() if isinstance(value, bool) else value
