"""The icon of the program in the format of Windows."""

import struct
from pathlib import Path

PICTURE = Path(__file__).resolve().parents[1] / "ui" / "public" / "icon.png"
_PNG_SIDES = struct.Struct(">16xII")  # width and height in pixels
_HEAD = struct.Struct("<HHH")
_ENTRY = struct.Struct("<BBBBHHII")


def icon_of(png: bytes) -> bytes:
    """Returns an icon file with one picture, which stays a PNG. Windows scales it to its smaller sizes."""
    width, height = (side % 256 for side in _PNG_SIDES.unpack_from(png))  # 0 stands for 256
    start = _HEAD.size + _ENTRY.size
    entry = _ENTRY.pack(width, height, 0, 0, 1, 32, len(png), start)
    return _HEAD.pack(0, 1, 1) + entry + png


def write_icon(file: Path) -> Path:
    """Writes the program's icon; returns its path."""
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(icon_of(PICTURE.read_bytes()))
    return file
