"""Signs that a class teaches: recorded through the camera, stored, and loaded into the camera's classifier."""

import contextlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from pinel_desktop.camera.client import CameraClient
from pinel_desktop.errors import PinelError
from pinel_desktop.events.app_events import SignRecording, SignsChanged
from pinel_desktop.gestures.letters import LANDMARKS, LETTERS
from pinel_desktop.gestures.typical_hand import Landmarks, landmarks_of_movement, medoid_landmarks
from pinel_desktop.messages import explain
from storage import SignSamples, Store, StoreError

N_SAMPLES = 10  # hands at rest in one recording
N_MOVEMENTS = 5
Samples = tuple[bytes, ...]


@dataclass(frozen=True, slots=True)
class KnownSign:
    """A sign that a capture can return for a class: a letter of Libras, or a sign that only the class taught.

    Attributes:
        n_samples, n_movements: how often the class showed the sign at rest and in motion.
        landmarks: hand from which the page draws a sign of the class; None for a letter, whose drawing ships.
    """

    name: str
    is_letter: bool
    n_samples: int
    n_movements: int
    landmarks: Landmarks | None = None


@dataclass(frozen=True, slots=True)
class _Recording:
    """The recording in progress."""

    classroom_id: str
    sign: str
    is_moving: bool

    @property
    def n_required(self) -> int:
        return N_MOVEMENTS if self.is_moving else N_SAMPLES

    @property
    def code_of_stop(self) -> str:
        """Code of the message that the recording was stopped."""
        return "movement_recording_stopped" if self.is_moving else "sign_recording_stopped"


class SignTeaching:
    """The signs of each class; thread-safe.

    Args:
        publish: sends an event to the page.
    """

    def __init__(
        self,
        store: Store,
        camera: CameraClient,
        publish: Callable[[dict[str, Any]], None],
        language: Callable[[], str],
    ) -> None:
        self._store, self._camera, self._publish = store, camera, publish
        self._language = language
        self._classroom_id: str | None = None

    def signs(self, classroom_id: str | None) -> list[KnownSign]:
        """Returns the letters, then the other signs that the class taught; without a class only the letters.

        While a detector reads the signs, returns its signs instead.

        Raises:
            StoreError: `classroom_not_found`.
        """
        recognizer = self._camera.recognizer
        if recognizer.in_use != LANDMARKS and recognizer.signs is not None:
            return [KnownSign(name, name in LETTERS, 0, 0) for name in recognizer.signs]
        taught = self._store.taught_signs.of_classroom(classroom_id) if classroom_id else []
        samples = {one.sign: one for one in taught}
        unknown = SignSamples("")
        letters = [_known(samples.get(letter, unknown), letter) for letter in LETTERS]
        return letters + [_known(one) for one in taught if one.sign not in LETTERS]

    def use(self, classroom_id: str | None) -> None:
        """Loads the signs of a class into the camera's classifier; None is a group without a class.

        Raises:
            StoreError: `classroom_not_found`; the classifier then stays unchanged.
        """
        taught = self._store.taught_signs.of_classroom(classroom_id) if classroom_id else []
        self._camera.set_taught_signs(
            tuple((one.sign, one.samples, one.movements) for one in taught)
        )
        self._classroom_id = classroom_id

    def refresh(self) -> None:
        """Loads the class's signs from the store again.

        Must be called after work was deleted or merged from another PC.
        """
        try:
            self.use(self._classroom_id)
        except StoreError as error:
            if error.code == "classroom_not_found":
                self.use(None)
        self._publish(SignsChanged(classroom=None).to_wire())

    def record(self, classroom_id: str, name: str, *, is_moving: bool = False) -> str:
        """Starts the recording of a sign, and publishes its progress. Returns the name as the class spells it.

        Args:
            is_moving: records movements, not hands at rest.

        Raises:
            StoreError: as `TaughtSigns.name_to_teach`.
            PinelError: `detector_cannot_learn`.
        """
        if self._camera.recognizer.in_use != LANDMARKS:
            raise PinelError("detector_cannot_learn")
        sign = self._store.taught_signs.name_to_teach(classroom_id, name, is_moving=is_moving)
        recording = _Recording(classroom_id, sign, is_moving)

        def on_samples(samples: Samples) -> None:
            self._publish_progress(recording, len(samples))
            if len(samples) == recording.n_required:
                self._save(recording, samples)

        self._publish_progress(recording, 0)  # the first hand may appear seconds later
        self._camera.record(
            recording.n_required,
            on_samples,
            lambda: self._publish_progress(
                recording, 0, problem=PinelError(recording.code_of_stop)
            ),
            is_moving=is_moving,
        )
        return sign

    def stop(self) -> None:
        """Stops the recording in progress; its samples are discarded."""
        self._camera.stop_recording()

    def forget(self, classroom_id: str, name: str) -> None:
        """Deletes all samples of a sign for good, also from the backups.

        Raises:
            StoreError: `classroom_not_found`, `taught_sign_not_found`.
        """
        self._camera.stop_recording()
        keys = self._store.taught_signs.keys(classroom_id, name)
        self._store.exchange.purge("taught_sign", *keys)
        self._use_again(classroom_id)

    def _save(self, recording: _Recording, samples: Samples) -> None:
        classroom_id, sign = recording.classroom_id, recording.sign
        try:
            self._store.taught_signs.add(
                classroom_id, sign, b"".join(samples), is_moving=recording.is_moving
            )
        except StoreError as error:  # the disk is full, or the class was deleted meanwhile
            self._publish_progress(recording, 0, problem=error)
            return
        self._use_again(classroom_id)
        self._publish_progress(recording, len(samples), is_stored=True)

    def _use_again(self, classroom_id: str) -> None:
        if classroom_id == self._classroom_id:
            with contextlib.suppress(StoreError):
                self.use(classroom_id)
        self._publish(SignsChanged(classroom=classroom_id).to_wire())

    def _publish_progress(
        self,
        recording: _Recording,
        n_samples: int,
        *,
        is_stored: bool = False,
        problem: PinelError | StoreError | None = None,
    ) -> None:
        text = explain(problem, self._language()) if problem else None
        event = SignRecording(
            classroom=recording.classroom_id,
            sign=recording.sign,
            is_moving=recording.is_moving,
            n_samples=n_samples,
            n_wanted=recording.n_required,
            is_kept=is_stored,
            code=problem.code if problem else None,
            params=dict(problem.params) if problem else {},
            message=text.message if text else "",
            remedy=text.remedy if text else "",
        )
        self._publish(event.to_wire())


def _known(taught: SignSamples, letter: str | None = None) -> KnownSign:
    counts = taught.n_samples, taught.n_movements
    if letter:
        return KnownSign(letter, True, *counts)
    if taught.hands:
        return KnownSign(taught.sign, False, *counts, medoid_landmarks(taught.hands))
    return KnownSign(taught.sign, False, *counts, landmarks_of_movement(taught.movements))
