"""Files that are pictures, and files that are not."""

import struct
import zlib
from pathlib import Path

import cv2
import numpy as np
import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.pictures import read_picture, unstretched


def png_header(width: int, height: int) -> bytes:
    """A PNG that promises a size and holds next to nothing."""

    def chunk(kind: bytes, content: bytes) -> bytes:
        return (
            struct.pack(">I", len(content))
            + kind
            + content
            + struct.pack(">I", zlib.crc32(kind + content))
        )

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", zlib.compress(b"\0"))
        + chunk(b"IEND", b"")
    )


def test_colours_come_in_the_order_red_green_blue(tmp_path: Path) -> None:
    file = tmp_path / "red.png"
    cv2.imwrite(str(file), np.full((20, 30, 3), (0, 0, 255), np.uint8))
    picture = read_picture(file)
    assert picture.shape == (20, 30, 3)
    assert picture[0, 0].tolist() == [255, 0, 0]


@pytest.mark.parametrize("shape", [(20, 30), (20, 30, 4)])
def test_grey_and_transparent_pictures_become_rgb(tmp_path: Path, shape: tuple[int, ...]) -> None:
    file = tmp_path / "a.png"
    cv2.imwrite(str(file), np.full(shape, 128, np.uint8))
    assert read_picture(file).shape == (20, 30, 3)


@pytest.mark.parametrize(
    "content",
    [b"", b"no picture", b"\xff\xd8\xff", png_header(20000, 5), png_header(60000, 60000)],
    ids=["empty", "text", "cut", "long", "bomb"],
)
def test_what_is_no_picture_is_said_to_be_none(tmp_path: Path, content: bytes) -> None:
    file = tmp_path / "a.jpg"
    file.write_bytes(content)
    with pytest.raises(PinelError) as raised:
        read_picture(file)
    assert raised.value.code == "picture_unreadable"
    assert raised.value.params == {"file": str(file)}


def test_a_missing_file_and_a_folder_are_no_pictures(tmp_path: Path) -> None:
    for path in (tmp_path / "none.png", tmp_path):
        with pytest.raises(PinelError) as raised:
            read_picture(path)
        assert raised.value.code == "picture_unreadable"


def test_a_tiny_picture_is_too_small(tmp_path: Path) -> None:
    file = tmp_path / "dot.png"
    cv2.imwrite(str(file), np.zeros((1, 1, 3), np.uint8))
    with pytest.raises(PinelError) as raised:
        read_picture(file)
    assert raised.value.code == "picture_too_small"


@pytest.mark.parametrize(
    ("aspect", "size"), [(16 / 9, (1138, 640)), (3 / 4, (640, 853)), (1.0, (640, 640))]
)
def test_a_square_gets_its_shape_back_and_no_side_shrinks(
    aspect: float, size: tuple[int, int]
) -> None:
    picture = unstretched(np.zeros((640, 640, 3), np.uint8), aspect)
    assert picture.shape == (size[1], size[0], 3)
