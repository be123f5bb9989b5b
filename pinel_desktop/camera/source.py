"""An open camera: its newest frame and its problem. Reading blocks, so it has a thread of its own."""

import logging
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from pinel_desktop.camera.frames import FrameReader, RawFrame, open_reader
from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.pictures import Picture

_log = logging.getLogger(__name__)

NO_FRAME_S = 2.0  # timeout without a frame: the camera is disconnected or hangs
SAME_FRAME_S = 3.0  # timeout with equal frames: noise makes the frames of a working camera differ
_RETRY_S = 1.0
_BLACK, _DARK = 8.0, 40.0  # mean brightness, 0 to 255
_CHECK_S = 0.5

OpenReader = Callable[[str], FrameReader]


@dataclass(frozen=True, slots=True)
class StampedFrame:
    """A frame and its arrival time on the monotonic clock, in s."""

    raw: RawFrame
    time_s: float


class CameraSource:
    """Reads a camera on a thread, and opens it again after it was unplugged; thread-safe.

    Args:
        address: as for `camera.frames.open_reader`.
        open_reader: opens the camera; may take seconds.
    """

    def __init__(self, address: str, open_reader: OpenReader = open_reader) -> None:
        self.address = address
        self._open_reader = open_reader
        self._changed = threading.Condition()
        self._frame: StampedFrame | None = None
        self._problem: PinelError | None = None
        self._is_open = False
        self._closing = threading.Event()
        self._opened_s = time.monotonic()
        self._quality_monitor = _ImageQualityMonitor(is_live=False)
        threading.Thread(target=self._read, name="camera-reader", daemon=True).start()

    def next_frame(self, after_s: float, timeout_s: float) -> StampedFrame | None:
        """Waits up to `timeout_s` for a frame later than `after_s`; returns the newest frame, or None on timeout."""
        with self._changed:
            self._changed.wait_for(lambda: self._is_newer(after_s), timeout_s)
            return self._frame if self._is_newer(after_s) else None

    @property
    def problem(self) -> PinelError | None:
        """The reason why the camera is unusable; None if it works or is being opened."""
        with self._changed:
            last_s = self._frame.time_s if self._frame else self._opened_s
            if self._problem:
                return self._problem
            if self._is_open and time.monotonic() - last_s > NO_FRAME_S:
                return PinelError("camera_no_picture")
            return None

    @property
    def is_open(self) -> bool:
        """Whether the camera is open and at least one frame has arrived."""
        with self._changed:
            return self._is_open and self._frame is not None

    def close(self) -> None:
        """Releases the camera once the driver returns from the current read; does not wait."""
        self._closing.set()

    def _is_newer(self, after_s: float) -> bool:
        return self._frame is not None and self._frame.time_s > after_s

    def _read(self) -> None:
        while not self._closing.is_set():
            try:
                reader = self._open_reader(self.address)
                try:
                    self._read_until_disconnected(reader)
                finally:
                    reader.close()
            except PinelError as error:
                self._try_again_after(error)
            except Exception:  # drivers raise anything; the camera may become usable later
                _log.exception("the camera %s cannot be read", self.address)
                self._try_again_after(PinelError("camera_no_picture"))

    def _try_again_after(self, error: PinelError) -> None:
        self._set_problem(error)
        self._closing.wait(_RETRY_S)

    def _read_until_disconnected(self, reader: FrameReader) -> None:
        with self._changed:
            self._is_open, self._opened_s = True, time.monotonic()
        self._quality_monitor = _ImageQualityMonitor(is_live=reader.is_live)
        last_s = time.monotonic()
        while not self._closing.is_set():
            raw = reader.read()
            now_s = time.monotonic()
            if raw is not None:
                last_s = now_s
                self._set_frame(StampedFrame(raw, now_s))
            elif now_s - last_s > NO_FRAME_S:
                self._set_problem(PinelError("camera_no_picture"))
                return
            else:
                self._closing.wait(0.02)  # without a frame, do not use the whole processor

    def _set_frame(self, frame: StampedFrame) -> None:
        problem = self._quality_monitor.problem(frame)
        with self._changed:
            self._frame, self._problem = frame, problem
            self._changed.notify_all()

    def _set_problem(self, error: PinelError) -> None:
        with self._changed:
            self._problem, self._is_open = error, False


class _ImageQualityMonitor:
    """Detects black, dark and frozen pictures. Checks twice a second."""

    def __init__(self, *, is_live: bool) -> None:
        self._is_live = is_live
        self._checked_s = float("-inf")
        self._problem: PinelError | None = None
        self._last: Picture | None = None
        self._changed_s = float("inf")

    def problem(self, frame: StampedFrame) -> PinelError | None:
        if frame.time_s - self._checked_s >= _CHECK_S:
            self._checked_s = frame.time_s
            self._problem = self._check(frame)
        return self._problem

    def _check(self, frame: StampedFrame) -> PinelError | None:
        small = frame.raw.picture[::8, ::8]
        if self._last is None or not np.array_equal(small, self._last):
            self._last, self._changed_s = small.copy(), frame.time_s
        brightness = float(small.mean())
        if brightness < _BLACK:
            return PinelError("camera_black")
        if self._is_live and frame.time_s - self._changed_s >= SAME_FRAME_S:
            return PinelError("camera_frozen")
        return PinelError("camera_dark") if brightness < _DARK else None
