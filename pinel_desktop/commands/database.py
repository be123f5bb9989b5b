"""Opens the database for commands, even while the app uses it; errors become `Failure`."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Protocol

from pinel_desktop.commands.printing import Failure
from pinel_desktop.database_locations import is_location_missing
from pinel_desktop.errors import PinelError
from storage import Store, StoreError, open_for_reading, open_store
from storage.text import name_key


class Named(Protocol):
    """A row with a name given by a person."""

    @property
    def id(self) -> str: ...
    @property
    def name(self) -> str: ...


@contextmanager
def opened_for_reading(path: Path) -> Iterator[Store]:
    """Opens the store of an existing file, read-only."""
    with _failures():
        require_location(path)
        _require(path)
        with open_for_reading(path) as store:
            yield store


@contextmanager
def opened_store(path: Path, *, may_be_new: bool) -> Iterator[Store]:
    """Opens the store of an intact file. Refuses a damaged file, because only the app repairs files.

    Args:
        may_be_new: create the file if it does not exist.
    """
    with _failures():
        require_location(path)
        if _has_content(path):
            _require_intact(path)
        elif not may_be_new:
            _require(path)
        with open_store(path) as store:
            yield store


def key_of(name_or_key: str, rows: Sequence[Named]) -> str:
    """Returns the key of the only row with this name or key. Raises PinelError `export_unknown`, `export_ambiguous`."""
    ids = [
        row.id
        for row in rows
        if name_or_key == row.id or name_key(row.name) == name_key(name_or_key)
    ]
    if not ids:
        raise PinelError("export_unknown", name=name_or_key, known=[row.name for row in rows])
    if len(ids) > 1:
        raise PinelError("export_ambiguous", name=name_or_key, ids=ids)
    return ids[0]


@contextmanager
def _failures() -> Iterator[None]:
    try:
        yield
    except (PinelError, StoreError) as error:
        raise Failure(error) from error


def _has_content(path: Path) -> bool:
    return path.is_file() and path.stat().st_size > 0


def require_location(path: Path) -> None:
    """Raises PinelError `database_place_missing` if the folder of a known database is missing.

    Otherwise a missing USB stick would lead to a new, empty file.
    """
    if is_location_missing(path):
        raise PinelError("database_place_missing", path=str(path), folder=str(path.parent))


def _require(path: Path) -> None:
    if not _has_content(path):
        raise PinelError("database_missing", path=str(path))


def _require_intact(path: Path) -> None:
    try:
        open_for_reading(path).close()
    except StoreError as error:
        if error.code != "database_older":
            raise
