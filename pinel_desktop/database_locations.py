"""Remembers where the work of this account lies, so that a stick that is away is not taken for a first start.

The list lies where PINEL keeps data by itself, not in the folder that may be away. A folder that the system empties
is no place for work, and not listed; nor is PINEL's own.
"""

import contextlib
import json
import os
from collections.abc import Sequence
from pathlib import Path

from pinel_desktop.paths import default_folder, is_in_default_folder, read_regular

_MAX_LOCATIONS = 20


def record_location(database: Path) -> None:
    """Notes that there is a database; of many places the oldest is forgotten."""
    import tempfile  # noqa: PLC0415 - a second start, which only asks, is to be quick

    known = _known()
    is_temporary = database.is_relative_to(os.path.realpath(tempfile.gettempdir()))
    if is_temporary or is_in_default_folder(database) or known[-1:] == [str(database)]:
        return
    others = [place for place in known if place != str(database)]
    _write([*others[1 - _MAX_LOCATIONS :], str(database)])


def forget_location(database: Path) -> None:
    """Lets the next start begin with an empty database there."""
    known = _known()
    if str(database) in known:
        _write([place for place in known if place != str(database)])


def is_location_missing(database: Path) -> bool:
    """True where there was a database at an earlier start, and now is nothing of it: its folder is away or empty."""
    beside = ("", "-wal", ".mark.json")
    parts = [database.with_name(f"{database.name}{suffix}") for suffix in beside]
    is_there = any(part.exists() for part in (*parts, database.parent / "backups"))
    return not is_there and str(database) in _known()


def _known() -> list[str]:
    try:
        found = json.loads(read_regular(_file()))
    except (OSError, ValueError, RecursionError):
        return []
    return [place for place in found if isinstance(place, str)] if isinstance(found, list) else []


def _write(places: Sequence[str]) -> None:
    file = _file()
    new = file.with_name(f"{file.name}.{os.getpid()}")
    with contextlib.suppress(OSError):  # as on a full disk
        file.parent.mkdir(0o700, parents=True, exist_ok=True)
        new.write_text(json.dumps(places), "utf-8")
        os.replace(new, file)


def _file() -> Path:
    return default_folder() / "places.json"
