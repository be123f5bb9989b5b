"""The camera process: reads messages, looks at frames while the camera is on, writes what it saw."""

import base64
import logging
import os
import queue
import threading
import time
from collections.abc import Callable
from dataclasses import replace
from typing import Any, BinaryIO

import numpy as np

from pinel_desktop.camera.annotation import annotated
from pinel_desktop.camera.learning import Learner, MovementTaker, SampleTaker
from pinel_desktop.camera.sight import SeenSign, Sight
from pinel_desktop.camera.source import CameraSource, Frame
from pinel_desktop.camera.wanted import Wanted
from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.opencv import cv2
from pinel_desktop.gestures.pictures import Picture
from pinel_desktop.gestures.sign_watch import SignWatch
from pinel_desktop.gestures.vote import Ballot, Decision
from pinel_desktop.processes.messages import PING, PONG, Message, read_messages, write_message

_END: Message = {"type": "end"}
_log = logging.getLogger(__name__)
_LOOK_HZ = 15.0
_TOLD_HZ = 10.0
_PREVIEW_SIDE = 480  # px, of the longer side
_JPEG_QUALITY = 70
_IDLE_S = 0.1
_MOVED_S = 1.2  # so long a sign that moved is told: an event may be lost, and people look up late


class CameraServer:
    """Does what the messages of one pipe want and writes what the camera sees to another, until the first one ends."""

    def __init__(
        self,
        messages: BinaryIO,
        events: BinaryIO,
        make_sight: Callable[[], Sight],
        open_source: Callable[[str], CameraSource] = CameraSource,
    ) -> None:
        self._messages, self._events = messages, events
        self._make_sight, self._open_source = make_sight, open_source
        self._orders: queue.SimpleQueue[Message] = queue.SimpleQueue()

    def serve(self) -> None:
        """Works until the messages end."""
        worker = threading.Thread(target=self._work_or_die, name="camera-worker")
        worker.start()
        for message in read_messages(self._messages):
            self._orders.put(message)
        self._orders.put(_END)
        worker.join()

    def _work_or_die(self) -> None:
        """A process whose worker failed must not live on in silence; the app starts another one."""
        try:
            self._work()
        except Exception:
            _log.exception("the camera process failed")
            os._exit(1)

    def _work(self) -> None:
        try:
            sight = self._make_sight()  # loads the networks: warm before the first capture
        except PinelError as error:
            self._refuse(error)
            return
        session = _Session(sight, self._send, self._open_source)
        self._send({"type": "camera_ready"})
        while (order := self._next_order(session)) is not _END:
            if order == PING:
                self._send(PONG)
            elif order:
                _obey(session, order)
            else:
                session.look()
        session.want(Wanted())

    def _refuse(self, error: PinelError) -> None:
        """Answers every order with the reason why nothing can be recognised."""
        self._send(_state("failed", error))
        self._send({"type": "camera_ready"})
        while (order := self._orders.get()) is not _END:
            self._send(PONG if order == PING else _state("failed", error))

    def _next_order(self, session: "_Session") -> Message | None:
        """The next order; None where none has come while the camera is on."""
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
    """The camera as the app wants it: on or off, looking for the answer of a capture or not."""

    def __init__(
        self,
        sight: Sight,
        send: Callable[[Message], None],
        open_source: Callable[[str], CameraSource],
    ) -> None:
        self._sight, self._send, self._open_source = sight, send, open_source
        self._source: CameraSource | None = None
        self._wanted = Wanted()
        self._signs = SignWatch()
        self._learner = Learner(sight.classifier)
        self._hand_taker, self._movement_taker = SampleTaker(), MovementTaker()
        self._moved: Decision | None = None
        self._moved_s = float("-inf")
        self._seen_s = self._told_s = 0.0
        self._state: Message = _state("off")

    @property
    def is_on(self) -> bool:
        return self._source is not None

    def obey(self, order: Message) -> None:
        """Does what a message says."""
        if order["type"] == "signs":
            self._learner.learn(order["signs"])
        else:
            self.want(Wanted.of(order))

    def want(self, wanted: Wanted) -> None:
        """Does what is wanted from now on."""
        if wanted.source != self._wanted.source:
            self._change_source(wanted.source)
        if wanted.capture != self._wanted.capture:
            self._signs.begin_anew()
        if wanted.record != self._wanted.record:
            self._hand_taker.begin_anew()
            self._movement_taker.begin_anew()
        self._wanted = wanted

    def look(self) -> None:
        """Looks at the next frame, if there is one soon."""
        if self._source is None:
            return
        frame = self._source.next_frame(self._seen_s, _IDLE_S)
        self._tell_how_it_is(self._source)
        if frame is None:
            return
        rest_s = self._seen_s + 1.0 / _LOOK_HZ - time.monotonic()
        self._seen_s = frame.time_s
        self._see(frame)
        time.sleep(min(max(rest_s, 0.0), _IDLE_S))

    def _change_source(self, address: str | None) -> None:
        if self._source:
            self._source.close()
        self._source = self._open_source(address) if address is not None else None
        self._sight.begin_anew()
        self._signs.begin_anew()
        self._tell_state(_state("opening" if self._source else "off"))

    def _tell_how_it_is(self, source: CameraSource) -> None:
        if problem := source.problem:
            self._tell_state(_state("failed", problem))
        elif source.is_open:
            self._tell_state(_state("on"))

    def _see(self, frame: Frame) -> None:
        if learnt := self._learner.take():
            self._sight.know(learnt.classifier, learnt.taught)
            self._signs.know(learnt.moving)
        hands = self._sight.look(frame.shot)
        self._record(frame, hands)
        decision = self._signs.see(*_ballot(frame, hands))
        if decision and decision.is_moving:
            self._moved, self._moved_s = decision, frame.time_s
        if self._wanted.capture and decision and not self._learner.is_busy:
            taught = decision.is_moving or any(
                hand.is_taught for hand in hands if hand.reading.best == decision.label
            )
            self._send(
                {
                    "type": "recognised",
                    "id": self._wanted.capture,
                    "label": decision.label,
                    "by": "taught" if taught else "camera",
                    "confidence": decision.confidence,
                    "second": decision.second,
                }
            )
            self._wanted = replace(self._wanted, capture=None)
        if frame.time_s - self._told_s >= 1.0 / _TOLD_HZ:
            self._told_s = frame.time_s
            self._tell(frame.shot.picture, hands)

    def _record(self, frame: Frame, hands: list[SeenSign]) -> None:
        number = self._wanted.record
        taker = self._movement_taker if self._wanted.record_moving else self._hand_taker
        if number and (sample := taker.take(frame.time_s, hands)):
            self._send({"type": "sample", "id": number, "hand": sample})

    def _tell(self, picture: Picture, hands: list[SeenSign]) -> None:
        height, width = picture.shape[:2]
        told = [_as_message(hand, width, height, mirror=self._wanted.mirror) for hand in hands]
        moved = self._moved if self._told_s - self._moved_s < _MOVED_S else None
        self._send(
            {
                "type": "sight",
                "hands": told,
                "label": self._signs.label,
                "progress": round(self._signs.progress, 2),
                "moved": moved.label if moved else "",
                "moved_confidence": moved.confidence if moved else 0.0,
                "aspect": round(width / height, 4),
            }
        )
        if self._wanted.preview:
            self._send({"type": "preview", "jpeg": _base64(self._shown(picture))})
        if self._wanted.annotated:
            shown = annotated(self._shown(picture), told, self._wanted.caption)
            self._send({"type": "annotated", "jpeg": _base64(shown)})

    def _shown(self, picture: Picture) -> Picture:
        """The picture as people see it: small, and as in a mirror."""
        scale = min(1.0, _PREVIEW_SIDE / max(picture.shape[:2]))
        small = cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
        return np.asarray(small[:, ::-1] if self._wanted.mirror else small, np.uint8)

    def _tell_state(self, state: Message) -> None:
        if state != self._state:
            self._state = state
            self._send(state)


def _obey(session: _Session, order: Message) -> None:
    try:
        session.obey(order)
    except (KeyError, TypeError):
        _log.warning("what the app wants is not understood: %.200s", order, exc_info=True)


def _ballot(frame: Frame, hands: list[SeenSign]) -> tuple[Ballot, bool]:
    """What the frame says, nothing where two hands show different signs; and whether the hand is a left one."""
    if not hands:
        return Ballot(frame.time_s, None), False
    sure = [hand for hand in hands if hand.reading.sign is not None]
    first = sure[0] if sure else hands[0]
    reading = first.reading
    label = reading.sign if len({hand.reading.sign for hand in sure}) == 1 else None
    ballot = Ballot(frame.time_s, label, reading.confidence, reading.second, first.points)
    return ballot, first.handedness == "left"


def _as_message(hand: SeenSign, width: int, height: int, *, mirror: bool) -> dict[str, Any]:
    """Landmarks as fractions of the picture's width and height, mirrored as the preview is."""
    points = hand.points / np.array([width, height], np.float32)
    if mirror:
        points[:, 0] = 1.0 - points[:, 0]
    return {
        "points": [[round(float(x), 3), round(float(y), 3)] for x, y in points],
        "handedness": hand.handedness,
        "best": hand.reading.best,
        "confidence": round(hand.reading.confidence, 3),
        "second": hand.reading.second,
        "sure": hand.reading.sign is not None,
    }


def _base64(shown: Picture) -> str:
    """The picture as JPEG."""
    picture = cv2.cvtColor(shown, cv2.COLOR_RGB2BGR)
    _, jpeg = cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, _JPEG_QUALITY])
    return base64.b64encode(jpeg.tobytes()).decode("ascii")


def _state(state: str, problem: PinelError | None = None) -> Message:
    code, params = (problem.code, problem.params) if problem else (None, {})
    return {"type": "camera_state", "state": state, "code": code, "params": params}
