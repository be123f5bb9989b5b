"""File permissions: on systems with accounts, only the account that PINEL runs in may read the file."""

import contextlib
import os
import stat
import sys
from collections.abc import Iterator
from pathlib import Path

PRIVATE_FOLDER, _PRIVATE_FILE = 0o700, 0o600


def restrict_permissions(path: Path, *, is_own_folder: bool) -> None:
    """Withdraws access to the database and the files beside it from other accounts of the PC.

    Ignores permissions that cannot be changed. A folder that somebody chose keeps its permissions, since a technician
    may share it among accounts. So does a folder with the set-group-ID bit, which is set for sharing.

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
        if not folder.stat().st_mode & 0o077:
            for file in _files(path):
                _restrict(file, _PRIVATE_FILE)
            for name in ("backups", "logs"):
                _restrict(folder / name, PRIVATE_FOLDER)


def _files(path: Path) -> Iterator[Path]:
    yield from path.parent.glob(f"{path.stem}.*")
    yield from (path.parent / "backups").glob(f"{path.stem}-*")


def _restrict(path: Path, mode: int) -> None:
    with contextlib.suppress(OSError):
        found = path.lstat()
        if (
            sys.platform != "win32"
            and found.st_uid == os.getuid()
            and found.st_mode & 0o077
            and not stat.S_ISLNK(found.st_mode)
        ):
            path.chmod(mode)
