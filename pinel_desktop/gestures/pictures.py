"""Pictures from files, brought to one form: RGB, 8 bits, unstretched."""

import os
import stat
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.opencv import cv2

Picture = NDArray[np.uint8]

MIN_SIDE = 16
_MAX_SIDE = 16384  # cv2 cuts no crops out of pictures twice as large
_MAX_FILE_BYTES = 100_000_000


def read_picture(path: Path, aspect: float | None = None) -> Picture:
    """The picture in a file, RGB (height, width, 3), turned as its EXIF data say.

    `aspect` is the width over the height that it had before it was stretched: the stretch is undone. Raises
    PinelError: `picture_unreadable`, `picture_too_small`, `picture_too_large`.
    """
    try:
        content = np.frombuffer(_content(path), np.uint8)
        decoded = cv2.imdecode(content, cv2.IMREAD_COLOR_RGB) if content.size else None
    except (OSError, cv2.error) as error:
        raise PinelError("picture_unreadable", file=str(path)) from error
    if decoded is None:
        raise PinelError("picture_unreadable", file=str(path))
    picture = np.asarray(decoded, np.uint8)
    _check_sides(path, picture)
    return unstretched(picture, aspect) if aspect else picture


def _content(path: Path) -> bytes:
    """The bytes of a file; b"" for a device or a pipe, which may have no end, and for what is too large."""
    with open(path, "rb", opener=_open_without_waiting) as file:
        status = os.fstat(file.fileno())
        if not stat.S_ISREG(status.st_mode) or status.st_size > _MAX_FILE_BYTES:
            return b""
        return file.read(_MAX_FILE_BYTES) or b""  # it may grow meanwhile


def _open_without_waiting(path: str, flags: int) -> int:
    """A pipe would be opened only when somebody writes to it."""
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))


def _check_sides(path: Path, picture: Picture) -> None:
    """Raises PinelError `picture_too_small`, `picture_too_large`."""
    height, width = picture.shape[:2]
    sides = {"file": str(path), "width": width, "height": height}
    if min(width, height) < MIN_SIDE:
        raise PinelError("picture_too_small", **sides, min=MIN_SIDE)
    if max(width, height) > _MAX_SIDE:
        raise PinelError("picture_too_large", **sides, max=_MAX_SIDE)


def unstretched(picture: Picture, aspect: float) -> Picture:
    """The picture with `aspect` as its width over its height; one side grows, none shrinks."""
    height, width = picture.shape[:2]
    size = (max(width, round(height * aspect)), max(height, round(width / aspect)))
    return np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_LINEAR), np.uint8)
