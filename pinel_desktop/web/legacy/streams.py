"""`GET /classify_stream`: starts a capture and streams the camera's pictures meanwhile."""

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

from pinel_desktop.camera.client import CameraClient
from pinel_desktop.errors import PinelError
from pinel_desktop.web.legacy.open_run import ExecuteOutcome, OpenRun
from pinel_desktop.web.legacy.pictures import Pictures
from pinel_desktop.web.legacy.run_store import Commands

# The original's page waits 10 s and then asks for the result, which must exist by then.
STREAM_S = 9.0
_END_CAPTURE_S = 8.0
# A robot or a busy PC may be slow to start the run. The capture then starts late, and still lasts
# `_MIN_CAPTURE_S`.
_START_S = 25.0
_MIN_CAPTURE_S = 3.0
CAPTURE: Commands = [{"action": "classify_gestures", "timeout": 8}]
_RESULT_S = 2.0
# After this time without a request for the next picture, the stream counts as unwatched.
_UNWATCHED_S = 3.0
_BUSY = ("bridge_busy", "run_in_progress")


@dataclass(slots=True)
class _Capture:
    """A capture with streams that watch it.

    Attributes:
        started_s, watched_s: time of its start, and of the last request or picture, by the monotonic clock.
        n_waiting: requests that wait for a picture or for the result.
        result_s: time of its result.
        has_camera: False after an error of the camera.
        over: set when the capture has a result.
    """

    started_s: float
    watched_s: float
    n_waiting: int = 0
    result_s: float | None = None
    has_camera: bool = True
    outcome: ExecuteOutcome | None = None
    over: threading.Event = field(default_factory=threading.Event)


@dataclass(frozen=True, slots=True)
class _Stream:
    """One connection; without a capture it only shows the camera."""

    started_s: float
    capture: _Capture | None


class Streams:
    """The streams of all connections; thread-safe.

    Args:
        caption: returns the caption in the pictures: for a capture that waits (None), or for its result.
    """

    def __init__(
        self, run: OpenRun, camera: CameraClient, caption: Callable[[str | None], str]
    ) -> None:
        self._run, self._camera, self._caption = run, camera, caption
        self._pictures = Pictures(camera)
        self._lock = threading.Lock()
        self._streams: dict[str, _Stream] = {}
        self._capture: _Capture | None = None

    def picture(self, request: str, *, may_capture: bool) -> bytes | None:
        """Returns the next picture of a stream, None at its end; the first one starts a capture unless a run is busy.

        Args:
            request: id of the stream.

        Raises:
            PinelError: the problem of the camera, such as `camera_missing`, or why no capture can start.
            StoreError: if the run cannot be stored.
        """
        with self._lock:
            stream = self._streams.get(request) or self._begin(request, may_capture)
            is_over = _is_over(stream)
            if is_over:
                del self._streams[request]
        if is_over:
            return None
        return self._next_picture(stream.capture)

    def current(self) -> _Capture | None:
        """Returns the capture without a result; None if there is none."""
        capture = self._capture
        return capture if capture and not capture.over.is_set() else None

    def settle(self) -> None:
        """Waits for the result of a capture whose time is over, because it may have started late."""
        capture = self.current()
        if capture and time.monotonic() - capture.started_s > _END_CAPTURE_S:
            with _waiting(capture):
                capture.over.wait(_START_S)

    def _next_picture(self, capture: _Capture | None) -> bytes:
        if capture is None:
            return self._pictures.next()
        with _waiting(capture):
            try:
                return self._pictures.next()
            except PinelError:
                capture.has_camera = False  # a person can still answer on the page
                raise

    def _begin(self, request: str, may_capture: bool) -> _Stream:
        now_s = time.monotonic()
        old = [one for one, it in self._streams.items() if now_s - it.started_s > 2 * STREAM_S]
        for one in old:
            del self._streams[one]
        capture = self.current() or (self._begin_capture(now_s) if may_capture else None)
        if capture is None:
            self._camera.caption("")
        stream = self._streams[request] = _Stream(now_s, capture)
        return stream

    def _begin_capture(self, now_s: float) -> _Capture | None:
        """Starts a capture; None if another run or call is busy, so that the stream only shows the camera."""
        # set before the capture starts, so that a call that comes meanwhile waits for it and gets
        # no `bridge_busy`
        self._capture = capture = _Capture(now_s, now_s)
        try:
            self._run.begin(CAPTURE)
        except BaseException as error:
            capture.over.set()
            if isinstance(error, PinelError) and error.code in _BUSY:
                return None
            raise
        self._camera.caption(self._caption(None))
        threading.Thread(target=self._follow, args=(capture,), daemon=True).start()
        return capture

    def _follow(self, capture: _Capture) -> None:
        capture.outcome = self._run.wait(lambda: self._end_if_due(capture))
        capture.result_s = time.monotonic()
        self._camera.caption(self._caption(self._run.result or ""))
        capture.over.set()

    def _end_if_due(self, capture: _Capture) -> bool:
        """Ends a capture that is over or that no page watches. Returns whether it failed to start in time."""
        now_s, started_s = time.monotonic(), self._run.capture_started_s
        if started_s is None:
            return now_s - capture.started_s > _START_S
        is_watched = (
            capture.n_waiting > 0
            or not capture.has_camera
            or now_s - max(capture.watched_s, started_s) < _UNWATCHED_S
        )
        due_s = max(capture.started_s + _END_CAPTURE_S, started_s + _MIN_CAPTURE_S)
        if not is_watched or now_s > due_s:
            self._run.end_capture()
        return False


@contextmanager
def _waiting(capture: _Capture) -> Iterator[None]:
    """Counts a waiting request, so that the capture counts as watched."""
    capture.n_waiting += 1
    try:
        yield
    finally:
        capture.n_waiting -= 1
        capture.watched_s = time.monotonic()


def _is_over(stream: _Stream) -> bool:
    now_s, capture = time.monotonic(), stream.capture
    shown_s = capture.result_s if capture else None
    is_shown = shown_s is not None and now_s - shown_s > _RESULT_S
    return is_shown or now_s - stream.started_s > STREAM_S
