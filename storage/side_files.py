"""Opens the small files beside the database, only if they are regular files.

A read of a pipe or a device with such a name could block for ever.
"""

import os
import stat
from pathlib import Path

_NEVER_WAIT = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)


def open_regular(path: Path, flags: int) -> int:
    """Opens a regular file and returns its descriptor. Raises OSError for anything else."""
    handle = os.open(path, flags | _NEVER_WAIT, 0o600)
    if not stat.S_ISREG(os.fstat(handle).st_mode):
        os.close(handle)
        raise OSError(f"{path}: no regular file")
    return handle


def read_regular(path: Path) -> bytes:
    """Returns the content of a regular file. Raises OSError for anything else."""
    with os.fdopen(open_regular(path, os.O_RDONLY), "rb") as file:
        return file.read()
