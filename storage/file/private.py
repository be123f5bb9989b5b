"""File permissions: on systems with accounts, only the account that PINEL runs in may read the file.

Or all accounts of a group, where a technician shares a folder among them.
"""

import contextlib
import os
import stat
import sys
from collections.abc import Iterator
from pathlib import Path

PRIVATE_FOLDER, _PRIVATE_FILE = 0o700, 0o600
_GROUP_FOLDER, _GROUP_FILE = 0o070, 0o060


def restrict_permissions(path: Path, *, is_own_folder: bool) -> None:
    """Withdraws access to the database and the files beside it from other accounts of the PC.

    Ignores permissions that cannot be changed. A folder that somebody chose keeps its permissions, since a technician
    may share it among accounts. So does a folder with the set-group-ID bit, which is set for sharing: if its group may
    write there, it may write the files too, which SQLite makes for the account alone.

    Args:
        path: the database.
        is_own_folder: whether it is in the folder that PINEL chooses by default.
    """
    if sys.platform == "win32":
        return
    with contextlib.suppress(OSError):
        folder = path.parent
        if is_own_folder and not folder.stat().st_mode & stat.S_ISGID:
            _restrict(folder, PRIVATE_FOLDER)
        mode = folder.stat().st_mode
        if mode & stat.S_ISGID and mode & stat.S_IWGRP:
            _share(path)
        if not mode & 0o077:
            for file in _files(path):
                _restrict(file, _PRIVATE_FILE)
            for name in ("backups", "logs"):
                _restrict(folder / name, PRIVATE_FOLDER)


def _share(path: Path) -> None:
    """Lets the group of the folder write the database and what is beside it."""
    for file in _files(path):
        _allow(file, _GROUP_FILE)
    for name in ("backups", "logs"):
        _allow(path.parent / name, _GROUP_FOLDER)
    for log in (path.parent / "logs").glob("*"):
        _allow(log, _GROUP_FILE)


def _files(path: Path) -> Iterator[Path]:
    yield from path.parent.glob(f"{path.stem}.*")
    yield from (path.parent / "backups").glob(f"{path.stem}-*")


def _restrict(path: Path, mode: int) -> None:
    with contextlib.suppress(OSError):
        if _own_mode(path) & 0o077:
            path.chmod(mode)


def _allow(path: Path, bits: int) -> None:
    with contextlib.suppress(OSError):
        mode = _own_mode(path)
        if mode and mode & bits != bits:
            path.chmod(mode | bits)


def _own_mode(path: Path) -> int:
    """Returns the permissions of a file or folder of this account; 0 for a link and for another account's."""
    found = path.lstat()
    is_own = sys.platform != "win32" and found.st_uid == os.getuid()
    return stat.S_IMODE(found.st_mode) if is_own and not stat.S_ISLNK(found.st_mode) else 0
