"""The icon of the program on Windows, and the picture of its installer."""

import struct
from pathlib import Path

import cv2

from tests.packaging.loading import load

icon = load("packaging/icon.py")


def test_the_icon_holds_the_picture_of_the_program(tmp_path: Path) -> None:
    file = icon.write_icon(tmp_path / "build" / "pinel.ico")
    content = file.read_bytes()
    kind, n_pictures, width, height, size, start = struct.unpack_from("<2xHHBB6xII", content)
    assert (kind, n_pictures) == (1, 1)
    assert (width, height) == (0, 0)  # 256
    assert content[start : start + size] == icon.PICTURE.read_bytes()


def test_the_picture_of_the_installer_is_plain_and_of_its_size(tmp_path: Path) -> None:
    picture = cv2.imread(str(icon.write_side_picture(tmp_path / "side.bmp")))
    assert picture is not None
    assert picture.shape == (314, 164, 3)
    assert picture.min(axis=(0, 1)).tolist() == picture.max(axis=(0, 1)).tolist()
