"""Reads pictures from files, as RGB with 8 bits, and undoes a stretch."""

import os
import stat
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.opencv import cv2

Picture = NDArray[np.uint8]

MIN_SIDE = 16
_MAX_SIDE = 16384  # px; cv2 makes no crops of pictures twice as large
_MAX_FILE_BYTES = 100_000_000


def read_picture(path: Path, aspect: float | None = None) -> Picture:
    """Reads a picture, RGB (height, width, 3), in the orientation of its EXIF data.

    Args:
        aspect: width divided by height before the picture was stretched; undoes the stretch. None if not stretched.

    Raises:
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
    """Returns the bytes of a file; b"" for a file that is too large, and for a device or a pipe, maybe endless."""
    with open(path, "rb", opener=_open_without_waiting) as file:
        status = os.fstat(file.fileno())
        if not stat.S_ISREG(status.st_mode) or status.st_size > _MAX_FILE_BYTES:
            return b""
        return file.read(_MAX_FILE_BYTES) or b""  # the file may grow meanwhile


def _open_without_waiting(path: str, flags: int) -> int:
    """Opens without blocking: opening a pipe would wait for a writer."""
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
    """Resizes the picture to `aspect`, width divided by height; enlarges one side and shrinks none."""
    height, width = picture.shape[:2]
    size = (max(width, round(height * aspect)), max(height, round(width / aspect)))
    return np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_LINEAR), np.uint8)
