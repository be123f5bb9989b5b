"""Paths of the user's data: `--db FILE`, else the folder PINEL_HOME, else the system's data folder for users."""

import os
import stat
from pathlib import Path

import platformdirs

DATABASE_NAME = "pinel.db"


def data_folder() -> Path:
    """Returns PINEL_HOME, or the default folder; it need not exist."""
    home = os.environ.get("PINEL_HOME")
    if home:
        return Path(home).expanduser()
    return default_folder()


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
