"""Folders for files that are exchanged between PCs: removable drives, and folders chosen by the teacher."""

import os
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import psutil

# where desktops of Linux and macOS mount removable drives
_MOUNT_POINTS = ("/media/", "/run/media/", "/mnt/", "/Volumes/")
_SUBFOLDER = "PINEL"


@dataclass(frozen=True, slots=True)
class ExchangeFile:
    """An exported file in a folder."""

    path: Path
    size_bytes: int
    modified_s: float


@dataclass(frozen=True, slots=True)
class Folder:
    """A folder for exchanged files, with the files in it.

    Attributes:
        is_removable: True for a removable drive.
        is_reachable: False for a chosen folder that cannot be read now, such as a share whose server is down.
        free_bytes: None if unknown.
    """

    path: Path
    name: str
    is_removable: bool
    is_reachable: bool
    is_writable: bool
    free_bytes: int | None
    files: tuple[ExchangeFile, ...]


def folders(
    suffix: str,
    chosen: Sequence[Path] = (),
    *,
    partitions: Callable[[], Sequence[Any]] | None = None,
) -> list[Folder]:
    """Returns removable drives, then the chosen folders, each with its files that end in `suffix`, newest first.

    Searches the folder and its subfolder `PINEL`. Omits removable drives that cannot be read.
    """
    found = [Path(one.mountpoint) for one in (partitions or _partitions)() if _is_removable(one)]
    drives = [_folder(path, True, suffix) for path in found if _is_folder(path)]
    others = [path for path in chosen if path not in found]
    return drives + [
        _folder(path, False, suffix) if _is_folder(path) else _unreachable(path) for path in others
    ]


def _partitions() -> Sequence[Any]:
    return psutil.disk_partitions(all=False)


def _is_removable(partition: Any) -> bool:
    if sys.platform == "win32":
        return "removable" in partition.opts.split(",")
    return str(partition.mountpoint).startswith(_MOUNT_POINTS)


def _is_folder(path: Path) -> bool:
    try:
        return path.is_dir()
    except OSError:  # a share whose server does not answer
        return False


def _folder(path: Path, is_removable: bool, suffix: str) -> Folder:
    found = [file for place in (path, path / _SUBFOLDER) for file in _files(place, suffix)]
    return Folder(
        path,
        path.name or str(path),
        is_removable,
        True,
        os.access(path, os.W_OK),
        _free_bytes(path),
        tuple(sorted(found, key=lambda file: (-file.modified_s, file.path))),
    )


def _unreachable(path: Path) -> Folder:
    return Folder(path, path.name or str(path), False, False, False, None, ())


def _files(place: Path, suffix: str) -> list[ExchangeFile]:
    found = []
    try:
        with os.scandir(place) as entries:
            for entry in entries:
                if entry.name.endswith(suffix) and entry.is_file():
                    about = entry.stat()
                    found.append(ExchangeFile(Path(entry.path), about.st_size, about.st_mtime))
    except OSError:
        return found
    return found


def _free_bytes(path: Path) -> int | None:
    try:
        return int(psutil.disk_usage(str(path)).free)
    except OSError:
        return None
