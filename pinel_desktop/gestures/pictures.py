"""Pictures from files, brought to one form: RGB, 8 bits, unstretched."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.opencv import cv2

Picture = NDArray[np.uint8]

SHORTEST_SIDE = 16
_LONGEST_SIDE = 16384  # cv2 cuts no crops out of pictures twice as large
_LARGEST_FILE = 100_000_000


def read_picture(path: Path, aspect: float | None = None) -> Picture:
    """The picture in a file, RGB (height, width, 3), turned as its EXIF data say.

    `aspect` is the width over the height that it had before it was stretched: the stretch is undone. Raises
    PinelError: `picture_unreadable`, `picture_too_small`.
    """
    try:
        if path.stat().st_size > _LARGEST_FILE:
            raise PinelError("picture_unreadable", file=str(path))
        content = np.frombuffer(path.read_bytes(), np.uint8)
        decoded = cv2.imdecode(content, cv2.IMREAD_COLOR_RGB) if content.size else None
    except (OSError, cv2.error) as error:
        raise PinelError("picture_unreadable", file=str(path)) from error
    if decoded is None or max(decoded.shape[:2]) > _LONGEST_SIDE:
        raise PinelError("picture_unreadable", file=str(path))
    if min(decoded.shape[:2]) < SHORTEST_SIDE:
        raise PinelError("picture_too_small", file=str(path), min=SHORTEST_SIDE)
    picture = np.asarray(decoded, np.uint8)
    return unstretched(picture, aspect) if aspect else picture


def unstretched(picture: Picture, aspect: float) -> Picture:
    """The picture with `aspect` as its width over its height; one side grows, none shrinks."""
    height, width = picture.shape[:2]
    size = (max(width, round(height * aspect)), max(height, round(width / aspect)))
    return np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_LINEAR), np.uint8)
