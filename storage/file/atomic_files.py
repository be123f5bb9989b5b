"""Atomic writing: files appear under their name only when they are complete. Also finds free file names."""

import errno
import os
import secrets
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from storage.file.open_files import delete, replace

_LEFTOVER_S = 3600.0  # since the last write; an export takes minutes


@contextmanager
def atomic_write(final: Path) -> Iterator[Path]:
    """Yields a path to write to; its file replaces `final` once complete and on disk. A failure leaves no file."""
    part = final.with_name(f".{final.name}.part")
    try:
        delete(part, missing_ok=True)
        yield part
        _sync(part)
        replace(part, final)
        _sync_folder(final.parent)
    finally:
        _remove(part)


@dataclass(slots=True)
class NewFile:
    """A file that is being written.

    Attributes:
        part: the path to write to.
        final: the path of the completed file.
    """

    part: Path
    final: Path


@contextmanager
def atomic_create(dest: Path) -> Iterator[NewFile]:
    """Yields a file that gets its name once it is complete and on disk. If the name is taken, it gets a number.

    A failure leaves no file. Files that a killed process left in the folder are deleted when a later one is completed.
    """
    part = dest.with_name(f".{dest.name}.{secrets.token_hex(4)}.part")
    new = NewFile(part, dest)
    try:
        yield new
        _sync(part)
        _remove_leftovers(part, dest.suffix)
        new.final = _placed(part, dest)
        _sync_folder(dest.parent)
    finally:
        _remove(part)


def _placed(part: Path, dest: Path) -> Path:
    for path in numbered(dest):
        with suppress(FileExistsError):
            _link(part, path)
            return path
    raise AssertionError("numbers do not end")


def _link(part: Path, final: Path) -> None:
    """Gives the file its name. Raises FileExistsError if the name is taken."""
    try:
        os.link(part, final)
    except FileExistsError:
        raise
    except OSError:  # FAT and some shares have no links: an empty file has the name for a moment
        final.open("xb").close()
        try:
            replace(part, final)
        except OSError:
            delete(final)
            raise


def _remove_leftovers(part: Path, suffix: str) -> None:
    """Deletes leftovers. Compares times on the disk, as PCs with other clocks write into a shared folder."""
    now_s = part.stat().st_mtime
    for left in part.parent.glob(f".*{suffix}.*part"):
        with suppress(OSError):
            if left.lstat().st_mtime < now_s - _LEFTOVER_S:
                left.unlink()


def _remove(part: Path) -> None:
    for suffix in ("", "-journal"):
        delete(part.with_name(part.name + suffix), missing_ok=True)


def numbered(path: Path, suffix: str | None = None) -> Iterator[Path]:
    """Yields the path, then the same path with 2, 3 and so on before its suffix."""
    ending = path.suffix if suffix is None else suffix
    yield path
    n = 1
    while True:
        n += 1
        yield path.with_name(f"{path.name.removesuffix(ending)}-{n}{ending}")


def free_path(path: Path, suffix: str | None = None) -> Path:
    """Returns the first path of `numbered` that does not exist."""
    return next(one for one in numbered(path, suffix) if not one.exists())


def _sync(path: Path) -> None:
    with path.open("rb+") as file:
        os.fsync(file.fileno())


def _sync_folder(folder: Path) -> None:
    """Puts the file's name on disk too. Systems that cannot sync a folder do so by themselves."""
    try:
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
    except OSError as error:
        if error.errno == errno.EIO:
            raise
