"""The small files beside the database: only regular ones are opened.

A pipe or a device of such a name would hold up who reads it for ever.
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
    """All of a regular file. Raises OSError for anything else."""
    with os.fdopen(open_regular(path, os.O_RDONLY), "rb") as file:
        return file.read()
