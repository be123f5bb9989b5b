"""Folders that files come from and go to: USB sticks that are plugged in, and a shared folder of the school."""

import os
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import psutil

# where desktops of Linux and macOS put what is plugged in
_PLUGGED_IN = ("/media/", "/run/media/", "/mnt/", "/Volumes/")
_SUBFOLDER = "PINEL"


@dataclass(frozen=True, slots=True)
class FileFound:
    """A file that somebody has exported."""

    path: Path
    size_bytes: int
    modified_s: float


@dataclass(frozen=True, slots=True)
class Folder:
    """A place for files, with those that it holds.

    Attributes:
        is_stick: whether it is a drive that was plugged in.
        is_reachable: False for a folder that was chosen and does not answer now: a network that is down.
        free_bytes: None where nobody can tell.
    """

    path: Path
    name: str
    is_stick: bool
    is_reachable: bool
    is_writable: bool
    free_bytes: int | None
    files: tuple[FileFound, ...]


def folders(
    suffix: str,
    chosen: Sequence[Path] = (),
    *,
    partitions: Callable[[], Sequence[Any]] | None = None,
) -> list[Folder]:
    """Sticks, and the folders that were chosen; each with its files of that ending, the newest first.

    A file counts that lies in the folder itself or in its folder `PINEL`. Sticks that cannot be read are left out.
    """
    found = [Path(one.mountpoint) for one in (partitions or _partitions)() if _is_stick(one)]
    sticks = [_folder(path, True, suffix) for path in found if _is_folder(path)]
    others = [path for path in chosen if path not in found]
    return sticks + [
        _folder(path, False, suffix) if _is_folder(path) else _unreachable(path) for path in others
    ]


def _partitions() -> Sequence[Any]:
    return psutil.disk_partitions(all=False)


def _is_stick(partition: Any) -> bool:
    if sys.platform == "win32":
        return "removable" in partition.opts.split(",")
    return str(partition.mountpoint).startswith(_PLUGGED_IN)


def _is_folder(path: Path) -> bool:
    try:
        return path.is_dir()
    except OSError:  # a share whose server is gone
        return False


def _folder(path: Path, is_stick: bool, suffix: str) -> Folder:
    found = [file for place in (path, path / _SUBFOLDER) for file in _files(place, suffix)]
    return Folder(
        path,
        path.name or str(path),
        is_stick,
        True,
        os.access(path, os.W_OK),
        _free_bytes(path),
        tuple(sorted(found, key=lambda file: (-file.modified_s, file.path))),
    )


def _unreachable(path: Path) -> Folder:
    return Folder(path, path.name or str(path), False, False, False, None, ())


def _files(place: Path, suffix: str) -> list[FileFound]:
    found = []
    try:
        with os.scandir(place) as entries:
            for entry in entries:
                if entry.name.endswith(suffix) and entry.is_file():
                    about = entry.stat()
                    found.append(FileFound(Path(entry.path), about.st_size, about.st_mtime))
    except OSError:
        return found
    return found


def _free_bytes(path: Path) -> int | None:
    try:
        return int(psutil.disk_usage(str(path)).free)
    except OSError:
        return None
