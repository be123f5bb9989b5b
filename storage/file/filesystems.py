"""File systems: free space, and whether a folder is on a network share."""

import re
import shutil
import sys
from collections.abc import Callable
from pathlib import Path

Free = Callable[[Path], int]

_MOUNTS = Path("/proc/self/mountinfo")
_SHARED = frozenset(
    [
        "afs",
        "ceph",
        "cifs",
        "davfs",
        "fuse.davfs",
        "fuse.davfs2",
        "fuse.glusterfs",
        "fuse.gvfsd-fuse",
        "fuse.rclone",
        "fuse.sshfs",
        "ncpfs",
        "nfs",
        "nfs3",
        "nfs4",
        "smb2",
        "smb3",
        "smbfs",
    ]
)
_REMOTE_DRIVE = 4


def free_bytes(folder: Path) -> int:
    """Returns the free bytes on the disk of a folder."""
    return shutil.disk_usage(folder).free


def is_on_share(folder: Path) -> bool:
    """Returns True for a folder that other PCs reach too; False also if that is unknown.

    SQLite's WAL works on one PC only, because its index is memory that the processes share.
    """
    if sys.platform == "win32":
        import ctypes  # noqa: PLC0415

        drive = folder.absolute().anchor
        return bool(ctypes.windll.kernel32.GetDriveTypeW(drive) == _REMOTE_DRIVE)
    try:
        mounts = _MOUNTS.read_text("utf-8", "surrogateescape")
        kind = kind_of_file_system(folder.resolve(), mounts)
    except OSError:
        return False
    return kind in _SHARED


def kind_of_file_system(folder: Path, mounts: str) -> str:
    """Returns the file system of a folder by Linux's list of mounts (proc(5), mountinfo)."""
    found, max_length = "", -1
    for line in mounts.splitlines():
        before, _, after = line.partition(" - ")
        place = _plain(before.split(" ")[4])
        if len(place) >= max_length and folder.is_relative_to(place):
            found, max_length = after.split(" ")[0], len(place)
    return found


def _plain(place: str) -> str:
    return re.sub(r"\\([0-7]{3})", lambda octal: chr(int(octal[1], 8)), place)
