"""The app's client of the camera process: supervises it, tracks its state, answers captures of a live run."""

import base64
import contextlib
import logging
import threading
import time
from collections.abc import Callable, Generator, Sequence
from dataclasses import dataclass, fields, replace
from itertools import count
from typing import Any, Literal

from pinel_desktop.camera.desired_state import DesiredState
from pinel_desktop.camera.preview import Preview
from pinel_desktop.camera.sample_recording import SampleRecording
from pinel_desktop.errors import PinelError
from pinel_desktop.events.app_events import CameraSight
from pinel_desktop.execution.inputs import Capture
from pinel_desktop.gestures.letters import LANDMARKS
from pinel_desktop.processes import own_command
from pinel_desktop.processes.heartbeat import HangTimeouts
from pinel_desktop.processes.messages import Message
from pinel_desktop.processes.supervisor import Supervisor

_log = logging.getLogger(__name__)

CameraMode = Literal["off", "opening", "on", "failed"]
WireEvent = dict[str, Any]
Taught = tuple[tuple[str, bytes, bytes], ...]

IDLE_OFF_S = 20.0  # idle timeout after the last use, so that the next capture finds the camera open
# Idle timeout of the process; the page calls `start` once a minute while a program with a capture is open.
IDLE_END_S = 300.0

# The process answers probes between two frames. Drivers and libraries may use the processor
# while it hangs, so a busy process gets no longer timeout.
_TIMEOUTS = HangTimeouts(hang_timeout_s=5.0, busy_timeout_s=5.0)
_WATCHDOG_PERIOD_S = 0.5
_PREVIEW_TIMEOUT_S = 5.0


@dataclass(frozen=True, slots=True)
class CameraState:
    """The mode of the camera and, if the camera is unusable, the reason as `problem`."""

    mode: CameraMode
    problem: PinelError | None = None


@dataclass(frozen=True, slots=True)
class RecognizerState:
    """The recognizer that was asked for.

    Attributes:
        name: as for `gestures.recognizers.open_recognizer`.
        is_loaded: whether the camera process has loaded it, or has found that it cannot.
        problem: why it cannot be used, so that the landmarks are used in its place; None if it can.
        signs: names of the signs that the recognizer in use can recognize; None if the process has not said them.
    """

    name: str = LANDMARKS
    is_loaded: bool = False
    problem: PinelError | None = None
    signs: tuple[str, ...] | None = None

    @property
    def in_use(self) -> str:
        """Name of the recognizer in use."""
        return LANDMARKS if self.problem else self.name


class CameraClient:
    """Client of the camera process; thread-safe. `start` starts the process, `switch_on` the camera itself.

    Args:
        source: address of the camera, as for `camera.frames.open_reader`.
        publish: receives each detection result as an event.
        on_change: called with each new state.
        answer: receives the id of a live run and the result of its capture. May raise PinelError if the run has
            ended.
        command: command line that starts the process.
        idle_off_s: idle timeout after the last use of the camera, in s.
        idle_end_s: idle timeout after the last `start` or use of the camera until the process ends, in s.
        timeouts: after these timeouts a hung process is replaced.
        on_recognizer: called when a recognizer was loaded or cannot be used.
        on_overhead: receives each message `overhead` of `camera/floor_watch.py`.
    """

    def __init__(  # noqa: PLR0913 - callbacks and timeouts, most with a default
        self,
        source: str,
        publish: Callable[[WireEvent], None],
        on_change: Callable[[CameraState], None],
        answer: Callable[[str, Capture], object],
        command: Sequence[str] | None = None,
        idle_off_s: float = IDLE_OFF_S,
        timeouts: HangTimeouts = _TIMEOUTS,
        on_recognizer: Callable[[RecognizerState], None] = lambda state: None,
        *,
        idle_end_s: float = IDLE_END_S,
        on_overhead: Callable[[Message], None] = lambda message: None,
    ) -> None:
        self._on_overhead = on_overhead
        self._source, self._idle_off_s = source, idle_off_s
        self._publish, self._on_change, self._answer = publish, on_change, answer
        self._on_recognizer = on_recognizer
        self._process = Supervisor(
            "camera",
            command or own_command("camera"),
            "camera_process_died",
            on_message=self._receive,
            on_death=self._died,
            on_ready=self._send_all,
            on_lost=self._lost,
            timeouts=timeouts,
            idle_end_s=idle_end_s,
        )
        self._lock = threading.RLock()
        self._has_recognizer = threading.Condition(self._lock)
        self._recognizer = RecognizerState(is_loaded=True)
        self._desired = DesiredState()
        self._state = CameraState("off")
        self._used_s = 0.0
        self._watchdog: threading.Thread | None = None
        self._closing = threading.Event()
        self._numbers = count()
        self._run: str | None = None
        self._preview, self._annotated = Preview(self._closing), Preview(self._closing)
        self._taught: Taught = ()
        self._recording: SampleRecording | None = None

    @property
    def state(self) -> CameraState:
        return self._state

    @property
    def source(self) -> str:
        return self._source

    @property
    def pid(self) -> int | None:
        """Id of the process; None while it does not run."""
        return self._process.pid

    @property
    def recognizer(self) -> RecognizerState:
        """The recognizer that was asked for."""
        return self._recognizer

    def set_recognizer(self, name: str) -> None:
        """Replaces the recognizer; a running process loads it meanwhile, else the next one does."""
        with self._lock:
            if name != self._desired.recognizer:
                self._recognizer = RecognizerState(name, is_loaded=name == LANDMARKS)
                self._update_desired(recognizer=name)

    def wait_for_recognizer(self, timeout_s: float) -> RecognizerState:
        """Starts the process, and waits until it has loaded the recognizer, or has found that it cannot."""
        self.start()
        with self._lock:
            self._has_recognizer.wait_for(lambda: self._recognizer.is_loaded, timeout_s)
            return self._recognizer

    def start(self) -> None:
        """Starts the process, so that its networks are loaded before a capture, or restarts its idle timeout.

        The camera stays off.
        """
        with self._lock:
            if self._closing.is_set():
                return
            if self._watchdog is None:
                self._watchdog = threading.Thread(
                    target=self._watchdog_loop, name="camera", daemon=True
                )
                self._watchdog.start()
            self._process.start()

    def wait_until_ready(self, timeout_s: float) -> bool:
        """Waits for the process, which `start` starts; False if it is not ready after `timeout_s`."""
        return self._process.wait_until_ready(timeout_s)

    def switch_on(self) -> None:
        """Switches the camera on, or restarts its idle timeout."""
        self.start()
        with self._lock:
            self._used_s = time.monotonic()
            if self._desired.source != self._source:
                self._update_desired(source=self._source)

    def set_source(self, source: str) -> None:
        """Replaces the camera by another one; a camera that is on is switched over at once."""
        with self._lock:
            self._source = source
            if self._desired.source is not None:
                self._update_desired(source=source)

    def watch_floor(self, setup: dict[str, float] | None) -> None:
        """Follows a robot with the camera above the floor; None ends that.

        Args:
            setup: fields of `overhead.markers.OverheadSetup`.
        """
        if setup:
            self.switch_on()
        with self._lock:
            self._used_s = time.monotonic()
            self._update_desired(overhead=setup)

    def set_taught_signs(self, taught: Taught) -> None:
        """Replaces the taught signs; the shipped letters remain.

        Args:
            taught: for each sign its name, hands at rest and movements, encoded as in the store.
        """
        with self._lock:
            if taught != self._taught:
                self._taught = taught
                self._send_taught()

    def record(
        self,
        n_samples: int,
        on_samples: Callable[[tuple[bytes, ...]], None],
        on_stop: Callable[[], None],
        *,
        is_moving: bool = False,
    ) -> None:
        """Records samples: hands at rest, one for each frame, or movements. Stops a recording in progress first.

        Args:
            on_samples: called after each sample with all samples so far; the last call has `n_samples`.
            on_stop: called if the recording is stopped, or times out without a sample.
        """
        self.stop_recording()
        with self._lock:
            self._recording = SampleRecording(n_samples, on_samples, on_stop)
            self._update_desired(record=str(next(self._numbers)), record_moving=is_moving)
        self.switch_on()

    def stop_recording(self) -> None:
        """Stops the recording in progress, if there is one."""
        with self._lock:
            recording, self._recording = self._recording, None
            self._update_desired(record=None)
        if recording:
            recording.on_stop()

    def observe(self, event: WireEvent) -> None:
        """Handles every event of a live run: a capture switches the camera on and is answered."""
        self._process.mark_used()  # the run may capture again at any time
        kind, run = event["type"], event["run"]
        if kind == "capture_started":
            self.switch_on()
            self._begin_capture(run, is_number=event.get("what") == "number")
        elif kind == "run_state" and run == self._run:
            self._hold(is_paused=event["state"] == "paused")
        elif kind in ("gesture_result", "run_ended") and run == self._run:
            self._end_capture()

    def previews(self, *, annotated: bool = False) -> Generator[bytes]:
        """Yields mirrored JPEG pictures to one viewer; ends if none arrives for `_PREVIEW_TIMEOUT_S`.

        Args:
            annotated: yields pictures with hands and signs drawn into them. The page draws them itself and uses
                False.
        """
        preview = self._annotated if annotated else self._preview
        flag = "annotated" if annotated else "preview"
        self.switch_on()
        try:
            # count under the lock: another viewer's `leave` must not switch this preview off
            with self._lock:
                self._update_desired(**{flag: preview.enter()})
            for picture in preview.pictures(_PREVIEW_TIMEOUT_S):
                self.switch_on()
                yield picture
        finally:
            with self._lock:
                self._update_desired(**{flag: preview.leave()})

    def caption(self, text: str) -> None:
        """Sets the caption of annotated pictures; "" for none."""
        with self._lock:
            self._update_desired(caption=text)

    def close(self) -> None:
        """Ends the process and all previews."""
        self._closing.set()
        self._preview.notify_closing()
        self._annotated.notify_closing()
        self._process.close()
        if self._watchdog:
            self._watchdog.join()

    def _begin_capture(self, run: str, *, is_number: bool) -> None:
        with self._lock:
            self._run = run
            self._update_desired(capture=str(next(self._numbers)), capture_number=is_number)

    def _hold(self, *, is_paused: bool) -> None:
        """Suspends the capture while the run is paused, and starts it again afterwards."""
        with self._lock:
            self._update_desired(capture=None if is_paused else str(next(self._numbers)))

    def _end_capture(self) -> None:
        with self._lock:
            self._run = None
            self._update_desired(capture=None)

    def _update_desired(self, **changes: Any) -> None:
        """Sends the desired state if it changed; the caller holds the lock."""
        desired = replace(self._desired, **changes)
        if desired != self._desired:
            self._desired = desired
            self._send_desired()

    def _send_all(self) -> None:
        """Sends the complete state to a process that has just started."""
        with self._lock:
            if self._taught:
                self._send_taught()
            self._send_desired()

    def _send_taught(self) -> None:
        if self._process.state == "ready":
            signs = [
                {"sign": sign, "samples": _base64(samples), "movements": _base64(movements)}
                for sign, samples, movements in self._taught
            ]
            self._process.send({"type": "signs", "signs": signs})

    def _send_desired(self) -> None:
        if self._process.state == "ready":
            self._process.send(self._desired.as_message())

    def _receive(self, message: Message) -> None:
        try:
            self._handle(message)
        except (KeyError, TypeError, ValueError):
            _log.warning(
                "the camera process sent what is no message: %.200s", message, exc_info=True
            )

    def _handle(self, message: Message) -> None:
        match message.get("type"):
            case "camera_state":
                code = message["code"]
                problem = PinelError(code, **message["params"]) if code else None
                self._change(CameraState(message["state"], problem))
            case "sight":
                values = {field.name: message[field.name] for field in fields(CameraSight)}
                self._publish(CameraSight(**values).to_wire())
            case "overhead":
                self._on_overhead(message)
            case "recognizer":
                self._recognizer_loaded(message)
            case "recognised":
                self._recognised(message)
            case "sample":
                self._sampled(message)
            case "preview":
                self._preview.show(base64.b64decode(message["jpeg"]))
            case "annotated":
                self._annotated.show(base64.b64decode(message["jpeg"]))

    def _recognised(self, message: Message) -> None:
        with self._lock:
            run = self._run
            if run is None or message["id"] != self._desired.capture:
                return  # a person answered, or the run was paused, while the message was in transit
            self._end_capture()
        capture = Capture(message["label"], message["by"], message["confidence"], message["second"])
        with contextlib.suppress(PinelError):  # the run has ended meanwhile
            self._answer(run, capture)

    def _recognizer_loaded(self, message: Message) -> None:
        code, signs = message["code"], tuple(message["signs"])
        problem = PinelError(code, **message["params"]) if code else None
        with self._lock:
            if message["name"] != self._desired.recognizer:
                return  # another one was chosen while the message was in transit
            self._recognizer = RecognizerState(message["name"], True, problem, signs)
            self._has_recognizer.notify_all()
        self._on_recognizer(self._recognizer)

    def _sampled(self, message: Message) -> None:
        with self._lock:
            recording = self._recording
            if recording is None or message["id"] != self._desired.record:
                return  # the recording was stopped while the message was in transit
            samples = recording.add(base64.b64decode(message["hand"]))
            if recording.is_complete:
                self._recording = None
                self._update_desired(record=None)
        recording.on_samples(samples)

    def _change(self, state: CameraState) -> None:
        self._state = state
        self._on_change(state)

    def _died(self) -> None:
        known = self._state.problem
        # `camera_process_lost` stays until the process works again
        if not (known and known.code == "camera_process_lost"):
            self._change(CameraState("failed", PinelError("camera_process_died")))

    def _lost(self) -> None:
        self._change(CameraState("failed", PinelError("camera_process_lost")))

    def _watchdog_loop(self) -> None:
        """Switches an idle camera off, and stops a recording that has timed out. A camera that is on is in use."""
        while not self._closing.wait(_WATCHDOG_PERIOD_S):
            with self._lock:
                is_used = (
                    self._run is not None
                    or self._recording is not None
                    or self._desired.overhead is not None
                )
                if not is_used and time.monotonic() - self._used_s > self._idle_off_s:
                    self._update_desired(source=None)
                if self._desired.source is not None:
                    self._process.mark_used()
                is_given_up = self._recording is not None and self._recording.is_given_up
            if is_given_up:
                self.stop_recording()


def _base64(octets: bytes) -> str:
    return base64.b64encode(octets).decode("ascii")
