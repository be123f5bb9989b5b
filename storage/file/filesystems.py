"""File systems: free space, and whether a folder is on a network share, or in memory that ends with the PC."""

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
_IN_MEMORY = frozenset(["ramfs", "rootfs", "tmpfs"])
# show one file system through another, which takes the changes
_LAYERED = frozenset(["aufs", "overlay"])
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
    return _mount_of(folder)[0] in _SHARED


def is_in_memory(folder: Path) -> bool:
    """Returns True for a folder that is empty, or as it was, when the PC starts again; False also if unknown.

    So on systems from a read-only image: live systems, and PCs that overlayroot and the like reset at each start.
    """
    kind, options = _mount_of(folder)
    upper = re.search(r"(?:^|,)upperdir=([^,]+)", options)
    if kind in _LAYERED and upper:
        kind, _ = _mount_of(Path(_plain(upper[1])))
    return kind in _IN_MEMORY or kind in _LAYERED


def _mount_of(folder: Path) -> tuple[str, str]:
    """Returns file system and options of a folder, on Linux; empty texts if unknown."""
    try:
        return mount_of(folder.resolve(), _MOUNTS.read_text("utf-8", "surrogateescape"))
    except OSError:
        return "", ""


def mount_of(folder: Path, mounts: str) -> tuple[str, str]:
    """Returns file system and options of a folder by Linux's list of mounts (proc(5), mountinfo)."""
    found, max_length = ("", ""), -1
    for line in mounts.splitlines():
        before, _, after = line.partition(" - ")
        place = _plain(before.split(" ")[4])
        if len(place) >= max_length and folder.is_relative_to(place):
            kind, *_, options = after.split(" ")
            found, max_length = (kind, options), len(place)
    return found


def _plain(place: str) -> str:
    return re.sub(r"\\([0-7]{3})", lambda octal: chr(int(octal[1], 8)), place)
