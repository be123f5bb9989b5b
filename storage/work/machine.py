"""Hashes that identify the machine, so that the store detects a copied data folder, and a copied disk.

The machine's id is in the disk's image, and the same on all PCs that were made from it. Their hardware differs.
"""

import hashlib
import sys
import uuid
from functools import cache
from pathlib import Path

from storage.work.hardware import Hardware, hardware_ids

_LINUX_IDS = (Path("/etc/machine-id"), Path("/var/lib/dbus/machine-id"))
_CHANCE_BIT = 1 << 40  # set if `getnode` found no network card and returned a random number


@cache
def machine_id_hash() -> str | None:
    """Returns the same hash at each start on this machine, from which its id cannot be derived.

    Returns None if the machine has no id.
    """
    found = _machine_id()
    return hashlib.sha256(f"pinel {found}".encode()).hexdigest() if found else None


@cache
def hardware_hashes() -> Hardware:
    """Returns hashes of the ids of this PC's hardware, by kind. Without the machine's id, none can be derived."""
    secret = _machine_id()
    return {
        kind: [hashlib.sha256(f"pinel {secret} {one}".encode()).hexdigest() for one in ids]
        for kind, ids in hardware_ids().items()
    }


def _machine_id() -> str:
    return _windows_id() or _linux_id() or _network_card()


def _linux_id() -> str:
    for path in _LINUX_IDS:
        try:
            found = path.read_text("ascii").strip()
        except (OSError, ValueError):
            continue
        if found and found != "uninitialized":
            return found
    return ""


def _windows_id() -> str:
    if sys.platform != "win32":
        return ""
    import winreg  # noqa: PLC0415 - on Windows only

    try:
        with winreg.OpenKey(
            winreg.HKEY_LOCAL_MACHINE,
            r"SOFTWARE\Microsoft\Cryptography",
            access=winreg.KEY_READ | winreg.KEY_WOW64_64KEY,
        ) as key:
            return str(winreg.QueryValueEx(key, "MachineGuid")[0])
    except OSError:
        return ""


def _network_card() -> str:
    node = uuid.getnode()
    return "" if node & _CHANCE_BIT else f"{node:012x}"
