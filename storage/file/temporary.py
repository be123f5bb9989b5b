"""Temporary folders for copies of files. A folder whose process was killed is deleted at a later start."""

import contextlib
import os
import shutil
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

if sys.platform == "win32":  # where an open file cannot be deleted
    fcntl = None
else:
    import fcntl

_PREFIX = "pinel-bundle-"
_LOCK = "lock"
_WITHOUT_LOCK_S = 86_400.0  # then it is left by an earlier release; a new one has no lock yet


@contextlib.contextmanager
def temporary_folder(parent: Path | None = None) -> Iterator[Path]:
    """Yields a new folder for this process alone. It is deleted at the end, or at a later start after a kill.

    Args:
        parent: the folder to make it in; None for the system's temporary folder.
    """
    with tempfile.TemporaryDirectory(
        prefix=_PREFIX, dir=parent, ignore_cleanup_errors=True
    ) as name:
        folder = Path(name)
        with (folder / f".{_LOCK}").open("wb") as lock:
            if fcntl is not None:
                fcntl.flock(lock, fcntl.LOCK_EX)
                # locked before it gets its name, so that no other process takes it for a leftover
                (folder / f".{_LOCK}").rename(folder / _LOCK)
            yield folder


def remove_leftovers(parent: Path | None = None) -> None:
    """Deletes folders whose process was killed or ended by a power cut; for `parent` see `temporary_folder`."""
    place = parent or Path(tempfile.gettempdir())
    with contextlib.suppress(OSError):
        for folder in [place / name for name in os.listdir(place) if name.startswith(_PREFIX)]:
            _remove_left(folder)


def _remove_left(folder: Path) -> None:
    with contextlib.suppress(OSError):
        if folder.is_dir() and not folder.is_symlink() and _is_left(folder):
            shutil.rmtree(folder, ignore_errors=True)


def _is_left(folder: Path) -> bool:
    for name in (_LOCK, f".{_LOCK}") if fcntl is None else (_LOCK,):
        lock = folder / name
        if lock.exists():
            return _is_free(lock)
    return folder.lstat().st_mtime < time.time() - _WITHOUT_LOCK_S


def _is_free(lock: Path) -> bool:
    try:
        if fcntl is None:
            lock.unlink()
            return True
        with lock.open("rb") as file:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        return False
    return True
