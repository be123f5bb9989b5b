"""Signs that a class teaches: recorded through the camera, kept in the store, known to the camera while it is the
class's turn."""

import contextlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

from pinel_desktop.errors import PinelError
from pinel_desktop.events.app_events import SignRecording, SignsChanged
from pinel_desktop.gestures.letters import LETTERS
from pinel_desktop.gestures.typical_hand import Landmarks, typical_landmarks
from pinel_desktop.messages import explain
from storage import Store, StoreError

N_SAMPLES = 10  # hands of one recording
Samples = tuple[bytes, ...]


class Camera(Protocol):
    """The part of `camera.client.Camera` that learns."""

    def know(self, taught: tuple[tuple[str, bytes], ...]) -> None: ...

    def record(
        self,
        n_samples: int,
        on_samples: Callable[[Samples], None],
        on_stop: Callable[[], None],
    ) -> None: ...

    def stop_recording(self) -> None: ...


@dataclass(frozen=True, slots=True)
class KnownSign:
    """A sign that captures of a class can answer: a letter that ships, with the class's samples of it, or its own.

    `landmarks` are those to draw a sign of the class from; None for a letter, whose drawing ships.
    """

    name: str
    is_letter: bool
    n_samples: int
    landmarks: Landmarks | None = None


class SignTeaching:
    """The signs of each class; thread-safe.

    Args:
        publish: sends an event to the page.
    """

    def __init__(
        self,
        store: Store,
        camera: Camera,
        publish: Callable[[dict[str, Any]], None],
        language: Callable[[], str],
    ) -> None:
        self._store, self._camera, self._publish = store, camera, publish
        self._language = language
        self._classroom_id: str | None = None

    def signs(self, classroom_id: str | None) -> list[KnownSign]:
        """The letters, then what the class taught besides; of groups without a class the letters.

        Raises:
            StoreError: `classroom_not_found`.
        """
        taught = self._store.taught_signs.of_classroom(classroom_id) if classroom_id else []
        counts = {one.sign: one.n_samples for one in taught}
        letters = [KnownSign(letter, True, counts.get(letter, 0)) for letter in LETTERS]
        return letters + [
            KnownSign(one.sign, False, one.n_samples, typical_landmarks(one.hands))
            for one in taught
            if one.sign not in LETTERS
        ]

    def use(self, classroom_id: str | None) -> None:
        """From now on the camera knows what this class taught; None is a group without a class.

        Raises:
            StoreError: `classroom_not_found`; the camera then knows what it knew.
        """
        taught = self._store.taught_signs.of_classroom(classroom_id) if classroom_id else []
        self._camera.know(tuple((one.sign, one.samples) for one in taught))
        self._classroom_id = classroom_id

    def refresh(self) -> None:
        """To be called when work was deleted or came from another PC: the camera knows what the store has now."""
        try:
            self.use(self._classroom_id)
        except StoreError as error:
            if error.code == "classroom_not_found":
                self.use(None)
        self._publish(SignsChanged(classroom=None).flat())

    def record(self, classroom_id: str, name: str) -> str:
        """Begins to record a sign; events tell how it goes on. Returns the name as the class spells it.

        Raises:
            StoreError: as `TaughtSigns.name_to_teach`.
        """
        sign = self._store.taught_signs.name_to_teach(classroom_id, name)

        def on_samples(samples: Samples) -> None:
            self._tell(classroom_id, sign, len(samples))
            if len(samples) == N_SAMPLES:
                self._keep(classroom_id, sign, samples)

        self._camera.record(
            N_SAMPLES,
            on_samples,
            lambda: self._tell(classroom_id, sign, 0, problem=PinelError("sign_recording_stopped")),
        )
        return sign

    def stop(self) -> None:
        """Gives up the recording that goes on."""
        self._camera.stop_recording()

    def forget(self, classroom_id: str, name: str) -> None:
        """Deletes all samples of a sign for good, also from the backups.

        Raises:
            StoreError: `classroom_not_found`, `taught_sign_not_found`.
        """
        self._camera.stop_recording()
        keys = self._store.taught_signs.keys(classroom_id, name)
        self._store.exchange.remove("taught_sign", *keys)
        self._use_again(classroom_id)

    def _keep(self, classroom_id: str, sign: str, samples: Samples) -> None:
        try:
            self._store.taught_signs.add(classroom_id, sign, b"".join(samples))
        except StoreError as error:  # the disk is full, or the class was deleted meanwhile
            self._tell(classroom_id, sign, 0, problem=error)
            return
        self._use_again(classroom_id)
        self._tell(classroom_id, sign, len(samples), is_kept=True)

    def _use_again(self, classroom_id: str) -> None:
        if classroom_id == self._classroom_id:
            with contextlib.suppress(StoreError):
                self.use(classroom_id)
        self._publish(SignsChanged(classroom=classroom_id).flat())

    def _tell(
        self,
        classroom_id: str,
        sign: str,
        n_samples: int,
        *,
        is_kept: bool = False,
        problem: PinelError | StoreError | None = None,
    ) -> None:
        words = explain(problem, self._language()) if problem else None
        event = SignRecording(
            classroom=classroom_id,
            sign=sign,
            n_samples=n_samples,
            n_wanted=N_SAMPLES,
            is_kept=is_kept,
            code=problem.code if problem else None,
            params=dict(problem.params) if problem else {},
            message=words.message if words else "",
            remedy=words.remedy if words else "",
        )
        self._publish(event.flat())
