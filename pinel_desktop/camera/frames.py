"""Frame readers: a webcam, a video file, a folder of pictures, a landmark sequence."""

import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import cycle
from pathlib import Path
from typing import Protocol

import numpy as np

from pinel_desktop.camera.address import number_of, path_of, pictures_of
from pinel_desktop.camera.landmark_sequence import (
    SEQUENCE_ENDING,
    RecordedHand,
    read_landmark_sequence,
)
from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.opencv import cv2
from pinel_desktop.gestures.pictures import MIN_SIDE, Picture, read_picture

WIDTH, HEIGHT = 640, 480
OVERHEAD_SIZE = 1280, 720  # of a camera above the floor, whose markers are small
_PICTURE_S = 1.5  # time for which a folder shows each picture
_FRAMES_HZ = 15.0
_MAX_SIDE = 1280  # px; larger frames cost time and improve no landmark
# OpenCV's own choice on Windows, Media Foundation, may need 10 s to open a webcam
_WEBCAM_API = cv2.CAP_DSHOW if sys.platform == "win32" else cv2.CAP_ANY
_TO_RGB = {1: cv2.COLOR_GRAY2RGB, 3: cv2.COLOR_BGR2RGB, 4: cv2.COLOR_BGRA2RGB}


@dataclass(frozen=True, slots=True)
class RawFrame:
    """A frame without time stamp: an RGB picture (height, width, 3); from a landmark sequence also its hands."""

    picture: Picture
    hands: tuple[RecordedHand, ...] | None = None


class FrameReader(Protocol):
    """Reads frames one after the other.

    Attributes:
        is_live: whether the frames come from a real camera. Noise makes all frames of a real camera different.
    """

    is_live: bool

    def read(self) -> RawFrame | None:
        """Returns the next frame, or None if none is available yet. May block."""
        ...

    def close(self) -> None:
        """Releases the camera."""


def open_reader(source: str, size: tuple[int, int] = (WIDTH, HEIGHT)) -> FrameReader:
    """Opens a frame source.

    Args:
        source: the number of a webcam ("0" is the first), or a path. The path is a video file, a folder of pictures, or
            a landmark sequence (.npz).
        size: width and height asked of a webcam, in px.

    Raises PinelError: `camera_missing`, `camera_busy`, `camera_source_missing`, `camera_source_unreadable`,
    `camera_folder_empty`.
    """
    number = number_of(source)
    if number is not None:
        return Webcam(number, size)
    path = path_of(source)
    if path.is_dir():
        return PictureFolder(path)
    return LandmarkSequence(path) if path.suffix == SEQUENCE_ENDING else VideoFile(path)


class Webcam:
    """A webcam, by its number."""

    is_live = True

    def __init__(self, number: int, size: tuple[int, int] = (WIDTH, HEIGHT)) -> None:
        self._device = cv2.VideoCapture(number, _WEBCAM_API)
        if not self._device.isOpened():
            code = "camera_busy" if _is_connected(number) else "camera_missing"
            raise PinelError(code, number=number + 1)
        self._device.set(cv2.CAP_PROP_FRAME_WIDTH, size[0])
        self._device.set(cv2.CAP_PROP_FRAME_HEIGHT, size[1])
        self._device.set(cv2.CAP_PROP_BUFFERSIZE, 1)  # buffered frames would be out of date

    def read(self) -> RawFrame | None:
        is_there, frame = self._device.read()
        return _raw_frame(as_rgb(frame)) if is_there else None

    def close(self) -> None:
        self._device.release()


class VideoFile:
    """A video at its own frame rate, in a loop."""

    is_live = False

    def __init__(self, path: Path) -> None:
        self._path = path
        self._video = cv2.VideoCapture(str(path))
        if not self._video.isOpened():
            raise PinelError("camera_source_unreadable", path=str(path))
        rate_hz = self._video.get(cv2.CAP_PROP_FPS)
        self._frame_s = 1.0 / rate_hz if 1.0 <= rate_hz <= 120.0 else 1.0 / 30.0
        self._due_s = time.monotonic()

    def read(self) -> RawFrame | None:
        self._due_s = _wait_until(self._due_s) + self._frame_s
        is_there, frame = self._video.read()
        if not is_there:
            self._video.set(cv2.CAP_PROP_POS_FRAMES, 0)
            is_there, frame = self._video.read()
        return _raw_frame(as_rgb(frame)) if is_there else None

    def close(self) -> None:
        self._video.release()


class PictureFolder:
    """The pictures of a folder, sorted by name, each for `_PICTURE_S`, in a loop."""

    is_live = False

    def __init__(self, path: Path) -> None:
        self._frames = self._endless(pictures_of(path))
        self._due_s = time.monotonic()

    def read(self) -> RawFrame | None:
        self._due_s = _wait_until(self._due_s) + 1.0 / _FRAMES_HZ
        return _raw_frame(next(self._frames))

    def close(self) -> None:
        return

    @staticmethod
    def _endless(files: list[Path]) -> Iterator[Picture | None]:
        for file in cycle(files):
            picture = _picture_or_none(file)
            for _ in range(round(_PICTURE_S * _FRAMES_HZ)):
                yield picture


class LandmarkSequence:
    """A recorded landmark sequence at 15 frames a second, in a loop; its pictures are plain grey."""

    is_live = False

    def __init__(self, path: Path) -> None:
        self._frames = cycle(read_landmark_sequence(path))
        self._picture = np.full((HEIGHT, WIDTH, 3), 128, np.uint8)
        self._due_s = time.monotonic()

    def read(self) -> RawFrame | None:
        self._due_s = _wait_until(self._due_s) + 1.0 / _FRAMES_HZ
        return RawFrame(self._picture, next(self._frames))

    def close(self) -> None:
        return


def _is_connected(number: int) -> bool:
    """Returns whether the system lists a webcam of that number, usable or not."""
    if sys.platform == "win32":
        return number < _n_usb_cameras()
    return Path(f"/dev/video{number}").exists()


if sys.platform == "win32":

    def _n_usb_cameras() -> int:
        """Returns how many devices the system's driver of USB webcams has now."""
        import winreg  # noqa: PLC0415 - only on Windows

        devices = r"SYSTEM\CurrentControlSet\Services\usbvideo\Enum"
        try:
            with winreg.OpenKey(winreg.HKEY_LOCAL_MACHINE, devices) as key:
                return int(winreg.QueryValueEx(key, "Count")[0])
        except OSError:  # no webcam since the start of Windows
            return 0


def _raw_frame(picture: Picture | None) -> RawFrame | None:
    return None if picture is None else RawFrame(picture)


def _picture_or_none(file: Path) -> Picture | None:
    """Reads a picture; None for a file that is no picture, damaged, too large, or too narrow for a hand."""
    try:
        return _reduced(read_picture(file))
    except PinelError:
        return None


def as_rgb(frame: object) -> Picture | None:
    """Converts a driver's frame to RGB, reduced to at most 1280 px a side; None for an invalid frame.

    Args:
        frame: grey, BGR or BGRA, as OpenCV delivers it.
    """
    if not isinstance(frame, np.ndarray) or frame.dtype != np.uint8 or frame.ndim not in (2, 3):
        return None
    channels = frame.shape[2] if frame.ndim == 3 else 1
    if min(frame.shape[:2]) < MIN_SIDE or channels not in _TO_RGB:
        return None
    small = _reduced(np.asarray(frame, np.uint8))
    return None if small is None else np.asarray(cv2.cvtColor(small, _TO_RGB[channels]), np.uint8)


def _reduced(picture: Picture) -> Picture | None:
    """Reduces a picture to at most 1280 px a side; None if the shorter side becomes shorter than `MIN_SIDE`."""
    scale = min(1.0, _MAX_SIDE / max(picture.shape[:2]))
    if scale * min(picture.shape[:2]) < MIN_SIDE:
        return None
    small = cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
    return np.asarray(small, np.uint8)


def _wait_until(due_s: float) -> float:
    """Waits until `due_s` of the monotonic clock; returns the later of `due_s` and now.

    So a late reader continues at the normal rate, and does not read faster to catch up.
    """
    now_s = time.monotonic()
    if due_s <= now_s:
        return now_s
    time.sleep(due_s - now_s)
    return due_s
