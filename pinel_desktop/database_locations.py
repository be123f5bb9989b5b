"""Records the locations of this account's databases, to distinguish a missing USB stick from a first start.

The list is in PINEL's default folder, which cannot be missing with the stick. It omits databases in PINEL's default
folder, and in temporary folders, which the system empties.
"""

import contextlib
import json
import os
from collections.abc import Sequence
from pathlib import Path

from pinel_desktop.paths import default_folder, is_in_default_folder, portable_folder, read_regular

_MAX_LOCATIONS = 20


def record_location(database: Path) -> None:
    """Records the location of a database as the newest; drops the oldest of more than `_MAX_LOCATIONS`."""
    known = _known()
    is_portable = (
        database.parent == portable_folder()
    )  # it is missing only together with the program
    if (
        is_temporary(database)
        or is_portable
        or is_in_default_folder(database)
        or known[-1:] == [str(database)]
    ):
        return
    others = [place for place in known if place != str(database)]
    _write([*others[1 - _MAX_LOCATIONS :], str(database)])


def is_temporary(database: Path) -> bool:
    """Returns whether the file is in the folder for temporary files."""
    import tempfile  # noqa: PLC0415 - a second start, which only reads the list, must be fast

    return database.is_relative_to(os.path.realpath(tempfile.gettempdir()))


def forget_location(database: Path) -> None:
    """Removes a location, so that the next start creates an empty database there."""
    known = _known()
    if str(database) in known:
        _write([place for place in known if place != str(database)])


def is_location_missing(database: Path) -> bool:
    """Returns whether an earlier start had a database here that is missing now: its folder is missing or empty."""
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
    # imported here, because the store would delay the window
    from storage.file.open_files import replace  # noqa: PLC0415

    file = _file()
    new = file.with_name(f"{file.name}.{os.getpid()}")
    with contextlib.suppress(OSError):  # such as a full disk
        file.parent.mkdir(0o700, parents=True, exist_ok=True)
        new.write_text(json.dumps(places), "utf-8")
        replace(new, file)


def _file() -> Path:
    return default_folder() / "places.json"
