"""Reads a folder of labelled photographs: `sources.csv`, `SPLIT/images/FILE`, `SPLIT/labels/FILE.txt`.

Columns of sources.csv: split,file,label,letter,source. A label file has one line, `class cx cy w h` of the hand's box,
in 0..1 of the picture. This is the format of "Alfabeto em libras" (Roboflow Universe, elainesilva, version 6,
CC BY 4.0).
"""

import csv
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.palms import Palm
from pinel_desktop.gestures.pictures import Picture, read_picture

# Width divided by height of each source's frames, before they were stretched to squares.
_WEBCAM, _PHONE = 16 / 9, 3 / 4
ASPECTS = {
    "p1_webcam": _WEBCAM,
    "p2_webcam": _WEBCAM,
    "p3_webcam": _WEBCAM,
    "p4_webcam": _WEBCAM,
    "g5_phone": _PHONE,
    "g6_whatsapp": _PHONE,
    "g8_phone_mix": _PHONE,
}
_TABLE = "sources.csv"
_COLUMNS = {"split", "file", "label", "letter", "source"}
# greatest distance of a palm's centre from the middle of the box, as a fraction of the box
_NEAR = 0.65
# size of the painted area relative to the box, so that no part of the hand's outline remains
_PAINTED = 1.2


@dataclass(frozen=True)
class Photo:
    """One photograph of a hand: its letter, its source, and the hand's box (cx, cy, w, h) in 0..1 of the picture."""

    path: Path
    letter: str
    source: str
    box: tuple[float, float, float, float]

    def picture(self) -> Picture:
        """Reads the picture, RGB, and undoes its stretch."""
        return read_picture(self.path, ASPECTS.get(self.source))

    def accepts(self, picture: Picture) -> Callable[[Palm], bool]:
        """Returns a function that decides whether a palm in this picture belongs to the labelled hand."""
        x, y, width, height = self._in_pixels(picture)

        def is_near(palm: Palm) -> bool:
            offsets = np.abs(palm.centre - (x, y))
            return bool((offsets < _NEAR * np.array([width, height])).all())

        return is_near

    def painted_over(self, picture: Picture) -> Picture:
        """Returns the picture with the hand painted over, in the mean colour of the painted area's border."""
        x, y, width, height = self._in_pixels(picture)
        left, right = _bounds(x, width * _PAINTED, picture.shape[1])
        top, bottom = _bounds(y, height * _PAINTED, picture.shape[0])
        inside = picture[top:bottom, left:right]
        border = np.concatenate([inside[0], inside[-1], inside[:, 0], inside[:, -1]])
        painted = picture.copy()
        painted[top:bottom, left:right] = border.mean(0).astype(np.uint8)
        return painted

    def _in_pixels(self, picture: Picture) -> NDArray[np.float64]:
        height, width = picture.shape[:2]
        return np.array(self.box) * [width, height, width, height]


def read_photos(folder: Path, table: Path | None = None) -> list[Photo]:
    """Returns the labelled photographs of a folder, in the order of its table; leaves out photographs without a letter.

    Args:
        folder: contains all splits, or is one of them.
        table: sources.csv; by default the file in the folder, or in the folder above.

    Raises:
        PinelError: `photos_unreadable`.
    """
    place = table or next(
        (p for p in (folder / _TABLE, folder.parent / _TABLE) if p.is_file()), None
    )
    if place is None:
        raise PinelError("photos_unreadable", path=str(folder / _TABLE))
    try:
        with place.open(encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        if not rows or not set(rows[0]) >= _COLUMNS:
            raise PinelError("photos_unreadable", path=str(place))
        labelled = [row for row in rows if row["letter"]]
        photos = [_photo(place.parent, row) for row in labelled]
    except (OSError, UnicodeDecodeError, csv.Error, ValueError) as error:
        raise PinelError("photos_unreadable", path=str(place)) from error
    inside = [photo for photo in photos if photo.path.is_relative_to(folder)]
    if not inside:
        raise PinelError("photos_unreadable", path=str(folder))
    return inside


def _photo(root: Path, row: dict[str, str]) -> Photo:
    """Reads one photograph's label. Raises OSError or ValueError if the label file is missing or invalid."""
    path = root / row["split"] / "images" / row["file"]
    label = root / row["split"] / "labels" / f"{path.stem}.txt"
    x, y, width, height = map(float, label.read_text("utf-8").split()[1:5])
    return Photo(path, row["letter"], row["source"], (x, y, width, height))


def _bounds(middle: float, extent: float, size: int) -> tuple[int, int]:
    """Returns first and one past the last pixel of an extent, inside the picture and not empty."""
    first = min(max(int(middle - extent / 2), 0), size - 1)
    return first, min(max(int(np.ceil(middle + extent / 2)), first + 1), size)
