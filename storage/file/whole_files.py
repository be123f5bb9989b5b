"""Files that appear under their name only when they are complete, and names that no file has yet."""

import errno
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def whole_file(final: Path) -> Iterator[Path]:
    """A path to write to; its file replaces `final` when it is complete and on disk. A failure leaves nothing."""
    part = final.with_name(f".{final.name}.part")
    try:
        part.unlink(missing_ok=True)
        yield part
        _sync(part)
        part.replace(final)
        _sync_folder(final.parent)
    finally:
        for suffix in ("", "-journal"):
            part.with_name(part.name + suffix).unlink(missing_ok=True)


def numbered(path: Path, suffix: str | None = None) -> Iterator[Path]:
    """The path, then the same with 2, 3 and so on before its suffix."""
    ending = path.suffix if suffix is None else suffix
    yield path
    n = 1
    while True:
        n += 1
        yield path.with_name(f"{path.name.removesuffix(ending)}-{n}{ending}")


def free_path(path: Path, suffix: str | None = None) -> Path:
    """The first of `numbered` where nothing is."""
    return next(one for one in numbered(path, suffix) if not one.exists())


def _sync(path: Path) -> None:
    with path.open("rb+") as file:
        os.fsync(file.fileno())


def _sync_folder(folder: Path) -> None:
    """Puts the file's name on disk too. Systems that cannot sync a folder do this by themselves."""
    try:
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
    except OSError as error:
        if error.errno == errno.EIO:
            raise
