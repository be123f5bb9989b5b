"""What a class taught, learnt beside the frames, and the frames and movements from which it is to learn."""

import base64
import logging
import threading
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.camera.sight import SeenSign
from pinel_desktop.gestures.classifier import Samples, SignClassifier
from pinel_desktop.gestures.features import N_FEATURES
from pinel_desktop.gestures.movements import N_FRAMES, N_NUMBERS, Glimpse, MovementWatch
from pinel_desktop.gestures.moving_signs import MovingSigns
from pinel_desktop.gestures.vote import rests

_log = logging.getLogger(__name__)
_SAMPLE_S = 0.12  # frames that follow each other at once show the same
_KEPT_AS = np.dtype("<f2")
_LARGEST = float(np.finfo(np.float16).max)


@dataclass(frozen=True, slots=True)
class Learnt:
    """A classifier, the names of the signs in it that a class taught, and the signs that move."""

    classifier: SignClassifier
    taught: frozenset[str] = frozenset()
    moving: MovingSigns = field(default_factory=lambda: MovingSigns({}))


class Learner:
    """Teaches a classifier on a thread of its own, so that frames go on meanwhile."""

    def __init__(self, classifier: SignClassifier) -> None:
        self._letters = classifier
        self._lock = threading.Lock()
        self._n_begun = 0
        self._learnt: Learnt | None = None
        self._is_busy = False

    @property
    def is_busy(self) -> bool:
        """Whether something is to be taken soon: what is recognised until then is not what the class means."""
        return self._is_busy

    def learn(self, signs: Sequence[dict[str, Any]]) -> None:
        """Begins with the letters that ship and these signs.

        Args:
            signs: of each `sign`, and `samples` and `movements`, base64 of float16 (n, 1748).
        """
        with self._lock:
            self._n_begun += 1
            self._is_busy = True
            number = self._n_begun
        threading.Thread(
            target=self._work, args=(number, signs), name="camera-learner", daemon=True
        ).start()

    def take(self) -> Learnt | None:
        """What was learnt since it was asked last; None for nothing."""
        with self._lock:
            learnt, self._learnt = self._learnt, None
            self._is_busy = self._is_busy and learnt is None
            return learnt

    def _work(self, number: int, signs: Sequence[dict[str, Any]]) -> None:
        try:
            learnt = self._taught(signs)
        except (KeyError, TypeError, ValueError, np.linalg.LinAlgError):
            _log.exception("signs cannot be learnt")
            learnt = Learnt(self._letters)
        with self._lock:
            if number == self._n_begun:  # else it is another class's turn already
                self._learnt = learnt

    def _taught(self, signs: Sequence[dict[str, Any]]) -> Learnt:
        moves = {sign["sign"]: _unpacked(sign["movements"]) for sign in signs}
        moving = {name: rows.reshape(-1, N_FRAMES, N_NUMBERS) for name, rows in moves.items()}
        known = MovingSigns({name: rows for name, rows in moving.items() if len(rows)})
        samples = [_unpacked(sign["samples"]) for sign in signs]
        names = [sign["sign"] for sign, found in zip(signs, samples, strict=True) for _ in found]
        if not names:
            return Learnt(self._letters, moving=known)
        classifier = self._letters.teach(Samples(np.concatenate(samples), tuple(names)))
        classifier.read(np.zeros(N_FEATURES, np.float32))  # derives what is derived once
        return Learnt(classifier, frozenset(names), known)


class SampleTaker:
    """Chooses frames from which a sign is to be learnt: one hand, at rest, each a moment after the one before."""

    def __init__(self) -> None:
        self.begin_anew()

    def begin_anew(self) -> None:
        """Forgets the frames so far."""
        self._points: NDArray[np.float32] | None = None
        self._seen_s = self._taken_s = float("-inf")

    def take(self, time_s: float, hands: Sequence[SeenSign]) -> str | None:
        """The hand of a good frame, packed as messages carry it; None for another frame."""
        before, elapsed_s = self._points, time_s - self._seen_s
        self._points, self._seen_s = (hands[0].points if len(hands) == 1 else None), time_s
        if self._points is None or before is None or not rests(before, self._points, elapsed_s):
            return None
        if time_s - self._taken_s < _SAMPLE_S:
            return None
        packed = pack(hands[0].features)
        self._taken_s = time_s if packed else self._taken_s
        return packed


class MovementTaker:
    """Cuts out the movements from which a sign is to be learnt: of one hand, from rest to rest."""

    def __init__(self) -> None:
        self._watch = MovementWatch()

    def begin_anew(self) -> None:
        """Forgets the frames so far."""
        self._watch.begin_anew()

    def take(self, time_s: float, hands: Sequence[SeenSign]) -> str | None:
        """The movement that ends with this frame, packed as messages carry it; None without one."""
        if len(hands) != 1:
            self._watch.begin_anew() if hands else None
            return None
        seen = hands[0]
        movement = self._watch.see(Glimpse(time_s, seen.points, seen.handedness == "left"))
        return None if movement is None else pack(movement)


def pack(numbers: NDArray[np.float32]) -> str | None:
    """Numbers of a sample as messages carry them; None for what half precision cannot hold."""
    if not (np.abs(numbers) <= _LARGEST).all():
        return None
    return base64.b64encode(numbers.astype(_KEPT_AS).tobytes()).decode("ascii")


def _unpacked(packed: str) -> NDArray[np.float32]:
    octets = base64.b64decode(packed, validate=True)
    return np.frombuffer(octets, _KEPT_AS).reshape(-1, N_FEATURES).astype(np.float32)
