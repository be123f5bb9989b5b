"""Hardware that tells PCs apart whose disks were copied from one image: such PCs have the same machine id.

Only what a user without rights can read, and what stays in the PC: no USB devices, no virtual network cards, and no
address that the system has made up for privacy.
"""

import os
import sys
import uuid
from collections.abc import Iterator
from functools import cache
from pathlib import Path

Hardware = dict[str, list[str]]  # ids by kind
NETWORK, DISK, BOARD = "network", "disk", "board"
_SYSTEM, _DEVICES = Path("/sys"), Path("/dev")
# what `addr_assign_type` is for the address that the card was made with
_PERMANENT = "0"
_NO_ADDRESS = "00:00:00:00:00:00"
# QEMU numbers the disks of each virtual PC alike
_BUSES, _NOT_UNIQUE = ("ata-", "nvme-", "mmc-"), "QEMU"


@cache
def hardware_ids() -> Hardware:
    """Returns the ids of this PC's hardware by kind; without the kinds of which none was found."""
    if sys.platform == "win32":
        found = {BOARD: _windows_board()}
    else:
        found = {NETWORK: sorted(_network_cards()), DISK: sorted(_disks())}
    return {kind: ids for kind, ids in found.items() if ids}


def is_other_hardware(one: Hardware, other: Hardware) -> bool:
    """Returns whether two PCs differ: in the network cards, or, if one has none, in the disks.

    Cheap disks share serial numbers, so network cards count first. A replaced disk is not another PC, a replaced main
    board is.
    """
    for kind in (NETWORK, BOARD, DISK):
        if kind in one and kind in other:
            return set(one[kind]).isdisjoint(other[kind])
    return False


def _network_cards() -> Iterator[str]:
    """Yields the addresses of the built-in network cards."""
    for card in _entries(_SYSTEM / "class" / "net"):
        if not (card / "device").exists() or _is_on_usb(card):
            continue
        address = _text(card / "address")
        if _text(card / "addr_assign_type") == _PERMANENT and address not in ("", _NO_ADDRESS):
            yield address


def _disks() -> Iterator[str]:
    """Yields the names, with model and serial number, of the built-in disks."""
    for link in _entries(_DEVICES / "disk" / "by-id"):
        disk = _SYSTEM / "class" / "block" / os.path.basename(os.path.realpath(link))
        is_whole = not (disk / "partition").exists() and _text(disk / "removable") == "0"
        is_card = _text(disk / "device" / "type") == "SD"
        is_unique = link.name.startswith(_BUSES) and _NOT_UNIQUE not in link.name
        if is_unique and is_whole and not is_card and not _is_on_usb(disk):
            yield link.name


def _is_on_usb(device: Path) -> bool:
    return "/usb" in os.path.realpath(device / "device")


def _entries(folder: Path) -> list[Path]:
    try:
        return list(folder.iterdir())
    except OSError:
        return []


def _text(file: Path) -> str:
    try:
        return file.read_text("ascii").strip()
    except (OSError, ValueError):
        return ""


def _windows_board() -> list[str]:
    """Returns the UUID of the main board, as Windows found it at its last start."""
    if sys.platform != "win32":
        return []
    import winreg  # noqa: PLC0415 - on Windows only

    try:
        with winreg.OpenKey(winreg.HKEY_LOCAL_MACHINE, r"SYSTEM\HardwareConfig") as key:
            return [str(uuid.UUID(str(winreg.QueryValueEx(key, "LastConfig")[0])))]
    except (OSError, ValueError):
        return []
