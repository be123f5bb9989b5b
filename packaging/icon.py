"""Pictures of the program in formats of Windows."""

import struct
from pathlib import Path

PICTURE = Path(__file__).resolve().parents[1] / "ui" / "public" / "icon.png"
_PNG_SIDES = struct.Struct(">16xII")  # width and height in pixels
_HEAD = struct.Struct("<HHH")
_ENTRY = struct.Struct("<BBBBHHII")
_BITMAP_HEAD = struct.Struct("<2sIIIIiiHHIIiiII")
# size in pixels that NSIS shows beside its last page, and the green of the icon
_SIDE_SIZE = (164, 314)
_GREEN_BGR = bytes((0x60, 0x7A, 0x0A))


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


def write_side_picture(file: Path) -> Path:
    """Writes the picture beside the installer's last page, a plain one; returns its path."""
    width, height = _SIDE_SIZE
    row = _GREEN_BGR * width
    rows = (row + bytes(-len(row) % 4)) * height  # each row has a multiple of 4 bytes
    start = _BITMAP_HEAD.size
    sizes = (start + len(rows), 0, start, 40, width, height, 1, 24, 0, len(rows), 0, 0, 0, 0)
    file.write_bytes(_BITMAP_HEAD.pack(b"BM", *sizes) + rows)
    return file
