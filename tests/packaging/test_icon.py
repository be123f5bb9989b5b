"""The icon of the program on Windows."""

import struct
from pathlib import Path

from tests.packaging.loading import load

icon = load("packaging/icon.py")


def test_the_icon_holds_the_picture_of_the_program(tmp_path: Path) -> None:
    file = icon.write_icon(tmp_path / "build" / "pinel.ico")
    content = file.read_bytes()
    kind, n_pictures, width, height, size, start = struct.unpack_from("<2xHHBB6xII", content)
    assert (kind, n_pictures) == (1, 1)
    assert (width, height) == (0, 0)  # 256
    assert content[start : start + size] == icon.PICTURE.read_bytes()
