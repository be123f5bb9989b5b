"""The camera process: reads messages, analyses frames while the camera is on, writes the detection results."""

import base64
import logging
import os
import queue
import threading
import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.camera.annotation import annotated
from pinel_desktop.camera.desired_state import DesiredState
from pinel_desktop.camera.floor_watch import FloorWatch
from pinel_desktop.camera.frame_analyzer import DetectedSign, FrameAnalyzer
from pinel_desktop.camera.frames import OVERHEAD_SIZE, open_reader
from pinel_desktop.camera.latest_job import LatestJob
from pinel_desktop.camera.number_spotter import (
    NO_NUMBER_SHOWN,
    NUMBERS,
    NumberSpotter,
    shown_number,
)
from pinel_desktop.camera.recognizer_loading import LoadedRecognizer, load_recognizer
from pinel_desktop.camera.sign_training import MovementCollector, SampleCollector, SignTrainer
from pinel_desktop.camera.source import CameraSource, StampedFrame
from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.moving.moving_signs import MovingSignClassifier
from pinel_desktop.gestures.opencv import cv2
from pinel_desktop.gestures.pictures import Picture
from pinel_desktop.gestures.sign_spotter import SignSpotter
from pinel_desktop.gestures.stability import Decision, FramePrediction
from pinel_desktop.processes.log_file import close_log
from pinel_desktop.processes.messages import PING, PONG, Message, read_messages, write_message

_END: Message = {"type": "end"}
_LOADED: Message = {"type": "recognizer_loaded"}  # from a thread of this process
_log = logging.getLogger(__name__)
_ANALYSIS_HZ = 15.0
_PUBLISH_HZ = 10.0
_PREVIEW_SIDE = 480  # px, of the longer side
_JPEG_QUALITY = 70
_IDLE_S = 0.1
_MOVING_SIGN_REPEAT_S = (
    1.2  # repeats the last moving sign: events are lossy, and readers of the screen are slow
)


class CameraServer:
    """Reads messages from one pipe and writes detection results to another, until the first pipe ends."""

    def __init__(
        self,
        messages: BinaryIO,
        events: BinaryIO,
        make_analyzer: Callable[[], FrameAnalyzer],
        open_source: Callable[[str], CameraSource] = CameraSource,
    ) -> None:
        self._messages, self._events = messages, events
        self._make_analyzer, self._open_source = make_analyzer, open_source
        self._orders: queue.SimpleQueue[Message] = queue.SimpleQueue()

    def serve(self) -> None:
        """Serves until the input pipe ends."""
        worker = threading.Thread(target=self._work_or_die, name="camera-worker")
        worker.start()
        for message in read_messages(self._messages):
            self._orders.put(message)
        self._orders.put(_END)
        worker.join()

    def _work_or_die(self) -> None:
        """Runs the worker. If it fails, exits the process, so that the app starts a new one."""
        try:
            self._work()
        except Exception:
            _log.exception("the camera process failed")
            close_log()
            os._exit(1)

    def _work(self) -> None:
        try:
            analyzer = self._make_analyzer()  # loads the networks before the first capture
        except PinelError as error:
            self._refuse(error)
            return
        loader = LatestJob[LoadedRecognizer]("recognizer-loader", lambda: self._orders.put(_LOADED))
        session = _Session(analyzer, loader, self._send, self._open_source)
        self._send({"type": "camera_ready"})
        while (order := self._next_order(session)) is not _END:
            if order == PING:
                self._send(PONG)
            elif order is _LOADED:
                session.use_loaded()
            elif order:
                _handle(session, order)
            else:
                session.poll_frame()
        session.apply(DesiredState())

    def _refuse(self, error: PinelError) -> None:
        """Answers every message with the error that prevents recognition."""
        self._send(_state("failed", error))
        self._send({"type": "camera_ready"})
        while (order := self._orders.get()) is not _END:
            self._send(PONG if order == PING else _state("failed", error))

    def _next_order(self, session: "_Session") -> Message | None:
        """Returns the next message. While the camera is on, does not wait and returns None if there is none."""
        try:
            return self._orders.get(block=not session.is_on)
        except queue.Empty:
            return None

    def _send(self, message: Message) -> None:
        try:
            write_message(self._events, message)
        except OSError:
            self._orders.put(_END)


class _Session:
    """Brings the camera into the desired state, and analyses its frames."""

    def __init__(
        self,
        analyzer: FrameAnalyzer,
        loader: LatestJob[LoadedRecognizer],
        send: Callable[[Message], None],
        open_source: Callable[[str], CameraSource],
    ) -> None:
        self._analyzer, self._send, self._open_source = analyzer, send, open_source
        self._loader = loader
        self._source: CameraSource | None = None
        self._desired = DesiredState()
        self._floor: FloorWatch | None = None
        self._spotter, self._number_spotter = SignSpotter(), NumberSpotter()
        self._trainer = SignTrainer(analyzer.classifier)
        self._sample_collector, self._movement_collector = SampleCollector(), MovementCollector()
        self._moving: MovingSignClassifier | None = None
        self._moved: Decision | None = None
        self._moved_s = float("-inf")
        self._last_frame_s = self._last_publish_s = 0.0
        self._state: Message = _state("off")

    @property
    def is_on(self) -> bool:
        return self._source is not None

    @property
    def _waits_for_number(self) -> bool:
        return self._desired.capture is not None and self._desired.capture_number

    def handle(self, order: Message) -> None:
        """Handles a message: new taught signs, or a new desired state."""
        if order["type"] == "signs":
            self._trainer.train(order["signs"])
        else:
            self.apply(DesiredState.of(order))

    def apply(self, desired: DesiredState) -> None:
        """Applies a new desired state."""
        if desired.overhead != self._desired.overhead:
            setup = desired.overhead
            self._floor = FloorWatch(setup, self._send) if setup else None
        if (desired.source, desired.overhead) != (self._desired.source, self._desired.overhead):
            self._change_source(desired.source)
        if desired.recognizer != self._desired.recognizer:
            self._loader.start(partial(load_recognizer, desired.recognizer))
        if desired.capture != self._desired.capture:
            self._spotter.reset()
            self._number_spotter.reset()
        if desired.record != self._desired.record:
            self._sample_collector.reset()
            self._movement_collector.reset()
        self._desired = desired

    def use_loaded(self) -> None:
        """Reads the next frames with the recognizer that was loaded; with landmarks if it cannot be used."""
        loaded = self._loader.pop_result()
        if loaded is None:
            return
        self._analyzer.use(loaded.recognizer)
        self._spotter.set_recognizer(
            self._analyzer.recognizer.min_confidence,
            self._moving if self._analyzer.has_landmarks else None,
        )
        self._number_spotter = NumberSpotter(self._analyzer.recognizer.min_confidence)
        self._send(loaded.as_message(self._analyzer.recognizer.signs))

    def poll_frame(self) -> None:
        """Analyses the next frame, if one arrives within `_IDLE_S`."""
        if self._source is None:
            return
        frame = self._source.next_frame(self._last_frame_s, _IDLE_S)
        self._send_source_state(self._source)
        if frame is None:
            return
        rest_s = self._last_frame_s + 1.0 / _ANALYSIS_HZ - time.monotonic()
        self._last_frame_s = frame.time_s
        self._process_frame(frame)
        time.sleep(min(max(rest_s, 0.0), _IDLE_S))

    def _change_source(self, address: str | None) -> None:
        if self._source:
            self._source.close()
        self._source = self._opened(address) if address is not None else None
        self._analyzer.reset()
        self._spotter.reset()
        self._send_state(_state("opening" if self._source else "off"))

    def _opened(self, address: str) -> CameraSource:
        if self._floor and self._open_source is CameraSource:
            return CameraSource(address, partial(open_reader, size=OVERHEAD_SIZE))
        return self._open_source(address)

    def _send_source_state(self, source: CameraSource) -> None:
        if problem := source.problem:
            self._send_state(_state("failed", problem))
        elif source.is_open:
            self._send_state(_state("on"))

    def _process_frame(self, frame: StampedFrame) -> None:
        if trained := self._trainer.pop_result():
            self._analyzer.set_classifier(trained.classifier, trained.taught)
            self._moving = trained.moving
            if self._analyzer.has_landmarks:
                self._spotter.set_moving_signs(trained.moving)
        if self._floor:
            self._floor.watch(frame)
            if self._desired.capture is None:  # hands would cost time
                if self._desired.preview:
                    self._publish(frame, [])
                return
        hands = self._analyzer.analyze(frame.raw, both=self._waits_for_number)
        self._record(frame, hands)
        decision = self._spotter.update(*_frame_prediction(frame, hands))
        if decision and decision.is_moving:
            self._moved, self._moved_s = decision, frame.time_s
        if self._waits_for_number:
            number = self._number_spotter.update(frame.time_s, hands)
            decision = decision if decision and _is_moving_number(decision) else number
        is_learning = self._trainer.is_busy or self._loader.is_busy
        if self._desired.capture and decision and not is_learning:
            taught = decision.is_moving or any(
                hand.is_taught for hand in hands if hand.prediction.best == decision.label
            )
            self._send(
                {
                    "type": "recognised",
                    "id": self._desired.capture,
                    "label": decision.label,
                    "by": "taught" if taught else "camera",
                    "confidence": decision.confidence,
                    "second": decision.second,
                }
            )
            self._desired = replace(self._desired, capture=None)
        self._publish(frame, hands)

    def _publish(self, frame: StampedFrame, hands: list[DetectedSign]) -> None:
        if frame.time_s - self._last_publish_s >= 1.0 / _PUBLISH_HZ:
            self._last_publish_s = frame.time_s
            self._send_sight(frame.raw.picture, hands)

    def _record(self, frame: StampedFrame, hands: list[DetectedSign]) -> None:
        number = self._desired.record
        collector = (
            self._movement_collector if self._desired.record_moving else self._sample_collector
        )
        if number and (sample := collector.update(frame.time_s, hands)):
            self._send({"type": "sample", "id": number, "hand": sample})

    def _send_sight(self, picture: Picture, hands: list[DetectedSign]) -> None:
        height, width = picture.shape[:2]
        hand_messages = [
            _as_message(hand, width, height, mirror=self._desired.mirror) for hand in hands
        ]
        moved = (
            self._moved if self._last_publish_s - self._moved_s < _MOVING_SIGN_REPEAT_S else None
        )
        self._send(
            {
                "type": "sight",
                "hands": hand_messages,
                "label": self._spotter.label,
                "progress": round(self._spotter.progress, 2),
                "moved": moved.label if moved else "",
                "moved_confidence": moved.confidence if moved else 0.0,
                "aspect": round(width / height, 4),
                "number": self._number_message(hands) if self._waits_for_number else None,
            }
        )
        if self._desired.preview:
            self._send({"type": "preview", "jpeg": _base64(self._shown(picture))})
        if self._desired.annotated:
            shown = annotated(self._shown(picture), hand_messages, self._desired.caption)
            self._send({"type": "annotated", "jpeg": _base64(shown)})

    def _number_message(self, hands: list[DetectedSign]) -> Message:
        """Returns the number that the hands of a frame show, as in the event `camera_sight`."""
        number = shown_number(hands) or NO_NUMBER_SHOWN
        return {
            "best": number.best,
            "confidence": round(number.confidence, 3),
            "second": number.second,
            "sure": number.is_sure,
            "progress": round(self._number_spotter.progress, 2),
        }

    def _shown(self, picture: Picture) -> Picture:
        """Returns the picture for the preview: at most `_PREVIEW_SIDE` px a side, mirrored if desired, but no floor."""
        scale = min(1.0, _PREVIEW_SIDE / max(picture.shape[:2]))
        small = cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
        return np.asarray(
            small[:, ::-1] if self._desired.mirror and not self._floor else small, np.uint8
        )

    def _send_state(self, state: Message) -> None:
        if state != self._state:
            self._state = state
            self._send(state)


def _handle(session: _Session, order: Message) -> None:
    try:
        session.handle(order)
    except (KeyError, TypeError):
        _log.warning("the order of the app is not valid: %.200s", order, exc_info=True)


def _frame_prediction(
    frame: StampedFrame, hands: list[DetectedSign]
) -> tuple[FramePrediction, bool]:
    """Returns the frame's prediction, and whether the hand is a left hand.

    If two hands show different signs, the prediction has no label.
    """
    if not hands:
        return FramePrediction(frame.time_s, None), False
    sure = [hand for hand in hands if hand.prediction.sign is not None]
    first = sure[0] if sure else hands[0]
    prediction = first.prediction
    label = prediction.sign if len({hand.prediction.sign for hand in sure}) == 1 else None
    frame_prediction = FramePrediction(
        frame.time_s, label, prediction.confidence, prediction.second, first.outline
    )
    return frame_prediction, first.handedness == "left"


def _is_moving_number(decision: Decision) -> bool:
    """Returns whether a movement that the class taught as a number was shown."""
    return decision.is_moving and decision.label in NUMBERS


def _as_message(hand: DetectedSign, width: int, height: int, *, mirror: bool) -> dict[str, Any]:
    """Returns the hand as a message, its box and landmarks as fractions of the picture's width and height.

    Args:
        mirror: mirrors box and landmarks, as the preview.
    """

    def fractions(points: NDArray[np.float32]) -> list[list[float]]:
        scaled = points / np.array([width, height], np.float32)
        if mirror:
            scaled[:, 0] = 1.0 - scaled[:, 0]
        return [[round(float(x), 3), round(float(y), 3)] for x, y in scaled]

    left, top, right, bottom = hand.box
    (one_x, low), (other_x, high) = fractions(np.array([[left, top], [right, bottom]], np.float32))
    return {
        "box": [min(one_x, other_x), low, max(one_x, other_x), high],
        "points": fractions(hand.points) if hand.points is not None else [],
        "handedness": hand.handedness,
        "best": hand.prediction.best,
        "confidence": round(hand.prediction.confidence, 3),
        "second": hand.prediction.second,
        "sure": hand.prediction.sign is not None,
    }


def _base64(shown: Picture) -> str:
    """Returns the picture as JPEG in base64."""
    picture = cv2.cvtColor(shown, cv2.COLOR_RGB2BGR)
    _, jpeg = cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, _JPEG_QUALITY])
    return base64.b64encode(jpeg.tobytes()).decode("ascii")


def _state(state: str, problem: PinelError | None = None) -> Message:
    code, params = (problem.code, problem.params) if problem else (None, {})
    return {"type": "camera_state", "state": state, "code": code, "params": params}
