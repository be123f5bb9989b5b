"""Where the user's data lives: `--db FILE`, else the folder PINEL_HOME, else the system's place for it."""

import os
import stat
from pathlib import Path

import platformdirs

DATABASE_NAME = "pinel.db"


def data_folder() -> Path:
    """PINEL_HOME, or the user's data folder; it need not exist."""
    home = os.environ.get("PINEL_HOME")
    if home:
        return Path(home).expanduser()
    return default_folder()


def is_in_default_folder(database: Path) -> bool:
    """Whether the file lies where PINEL keeps data by itself, not in a folder that somebody has chosen."""
    return database.parent == Path(os.path.realpath(default_folder()))


def default_folder() -> Path:
    """Where PINEL keeps data by itself; it need not exist."""
    return Path(platformdirs.user_data_dir("pinel", appauthor=False))


def database_path(db: str | os.PathLike[str] | None = None) -> Path:
    """The database file: `db` where one was given, else `pinel.db` in the data folder.

    Without links: who comes by one finds the same lock, log and backups.
    """
    path = Path(db).expanduser() if db else data_folder() / DATABASE_NAME
    return Path(os.path.realpath(path))


def read_regular(path: Path) -> bytes:
    """All of a regular file: a pipe or a device of that name would hold up who reads it for ever.

    As in storage/side_files.py: importing the store would delay the page and the window.

    Raises:
        OSError: there is none, or something else.
    """
    handle = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    if not stat.S_ISREG(os.fstat(handle).st_mode):
        os.close(handle)
        raise OSError(f"{path}: no regular file")
    with os.fdopen(handle, "rb") as file:
        return file.read()
