"""Paths of the user's data.

In this order: `--db FILE`; the folder PINEL_HOME; the folder beside the portable program; the system's data folder for
users.
"""

import os
import stat
import sys
from pathlib import Path

import platformdirs

DATABASE_NAME = "pinel.db"
# the folder beside the folder of the portable program, such as on a USB stick
PORTABLE_DATA = "pinel-data"
# written beside the packaged program (packaging/notices.py)
_NOTICES = "THIRD-PARTY-NOTICES.txt"


def data_folder() -> Path:
    """Returns PINEL_HOME, the folder of the portable program, or the default folder; it need not exist."""
    home = os.environ.get("PINEL_HOME")
    if home:
        return Path(home).expanduser()
    return portable_folder() or default_folder()


def portable_folder() -> Path | None:
    """Returns the folder for data beside the packaged program's folder; None if nobody has made it."""
    program = _packaged_program()
    folder = program and program.parents[1] / PORTABLE_DATA
    return folder if folder and folder.is_dir() else None


def notices_file() -> Path | None:
    """Returns the file with the licence notices of the packaged program; None without a package."""
    program = _packaged_program()
    return program and program.with_name(_NOTICES)


def _packaged_program() -> Path | None:
    if not getattr(sys, "frozen", False):
        return None
    return Path(os.path.realpath(sys.executable))


def is_in_default_folder(database: Path) -> bool:
    """Returns whether the file is in the default folder, not in a folder that somebody has chosen."""
    return database.parent == Path(os.path.realpath(default_folder()))


def default_folder() -> Path:
    """Returns the folder for data if nobody has chosen another; it need not exist."""
    return Path(platformdirs.user_data_dir("pinel", appauthor=False))


def database_path(db: str | os.PathLike[str] | None = None) -> Path:
    """Returns the path of the database file: `db` if given, else `pinel.db` in the data folder.

    Resolves links, so that a start through a link finds the same lock, log and backups.
    """
    path = Path(db).expanduser() if db else data_folder() / DATABASE_NAME
    return Path(os.path.realpath(path))


def read_regular(path: Path) -> bytes:
    """Reads a regular file. Refuses a pipe or a device, which could block the reader for ever.

    A copy of the function in storage/side_files.py, because an import of the store would delay the page and the window.

    Raises:
        OSError: the path does not exist, or is no regular file.
    """
    handle = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    if not stat.S_ISREG(os.fstat(handle).st_mode):
        os.close(handle)
        raise OSError(f"{path}: no regular file")
    with os.fdopen(handle, "rb") as file:
        return file.read()
