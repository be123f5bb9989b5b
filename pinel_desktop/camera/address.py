"""Addresses of frame sources (a webcam's number, or a path) and names of recognizers, checked without OpenCV."""

from pathlib import Path

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.letters import LANDMARKS, YOLO
from pinel_desktop.gestures.yolo.address import check_file

PICTURE_ENDINGS = (".bmp", ".jpeg", ".jpg", ".png", ".webp")
_MAX_DIGITS = 3


def number_of(source: str) -> int | None:
    """Returns the number of a webcam, 0 is the first; None for a path. Raises PinelError `camera_missing` above 999."""
    if not source.isdecimal():
        return None
    if len(source) > _MAX_DIGITS:
        raise PinelError("camera_missing", number=source)
    return int(source)


def path_of(source: str) -> Path:
    """Returns the file or folder with this path. Raises PinelError `camera_source_missing`."""
    path = Path(source)
    try:
        is_there = bool(source) and (path.is_file() or path.is_dir())
    except OSError:  # an invalid file name, or a folder without permission to enter
        is_there = False
    if not is_there:
        raise PinelError("camera_source_missing", path=source)
    return path


def pictures_of(folder: Path) -> list[Path]:
    """Returns a folder's pictures, sorted by name.

    Raises PinelError `camera_folder_empty`, `camera_source_unreadable`.
    """
    try:
        files = sorted(file for file in folder.iterdir() if file.suffix.lower() in PICTURE_ENDINGS)
    except OSError as error:
        raise PinelError("camera_source_unreadable", path=str(folder)) from error
    if not files:
        raise PinelError(
            "camera_folder_empty", path=str(folder), allowed=", ".join(PICTURE_ENDINGS)
        )
    return files


def check_address(source: str) -> None:
    """Checks an address as far as possible without opening the source. Raises PinelError as the functions above."""
    if number_of(source) is None:
        path = path_of(source)
        if path.is_dir():
            pictures_of(path)


def check_recognizer(name: str) -> None:
    """Checks the name of a recognizer as far as possible without opening it: `landmarks`, or `yolo:FILE`.

    Raises PinelError `recognizer_unknown`, or as `yolo.address.check_file`.
    """
    kind, _, file = name.partition(":")
    if name == LANDMARKS:
        return
    if kind != YOLO or not file:
        raise PinelError("recognizer_unknown", name=name)
    check_file(Path(file))
