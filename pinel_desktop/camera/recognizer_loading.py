"""Loads the chosen recognizer on a thread of its own, because it may take seconds."""

import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.letters import LANDMARKS
from pinel_desktop.gestures.recognizer import SignRecognizer
from pinel_desktop.gestures.recognizers import open_recognizer
from pinel_desktop.processes.messages import Message


@dataclass(frozen=True, slots=True)
class LoadedRecognizer:
    """The result of loading a recognizer by its name.

    Attributes:
        recognizer: None for the one of the landmarks, which is always loaded, and after a problem.
        problem: why it cannot be used; None if it can.
    """

    name: str
    recognizer: SignRecognizer | None = None
    problem: PinelError | None = None

    def as_message(self, signs: Sequence[str]) -> Message:
        """Returns the message to the app: the recognizer asked for, its problem, and the signs of the one in use."""
        code, params = (self.problem.code, self.problem.params) if self.problem else (None, {})
        return {
            "type": "recognizer",
            "name": self.name,
            "signs": list(signs),
            "code": code,
            "params": params,
        }


class RecognizerLoader:
    """Loads recognizers one after the other; of several the last one counts.

    Args:
        notify: called on the loading thread when a result can be fetched with `pop_result`.
    """

    def __init__(self, notify: Callable[[], None]) -> None:
        self._notify = notify
        self._lock = threading.Lock()
        self._n_started = 0
        self._result: LoadedRecognizer | None = None
        self._is_busy = False

    @property
    def is_busy(self) -> bool:
        """Whether a recognizer is being loaded; the one before must not answer captures meanwhile."""
        return self._is_busy

    def load(self, name: str) -> None:
        """Starts to load a recognizer, as `open_recognizer` names it."""
        with self._lock:
            self._n_started += 1
            self._is_busy = True
            number = self._n_started
        threading.Thread(
            target=self._work, args=(number, name), name="recognizer-loader", daemon=True
        ).start()

    def pop_result(self) -> LoadedRecognizer | None:
        """Returns the result of the last loading, once; None without one."""
        with self._lock:
            result, self._result = self._result, None
            self._is_busy = self._is_busy and result is None
            return result

    def _work(self, number: int, name: str) -> None:
        try:
            recognizer = None if name == LANDMARKS else open_recognizer(name)
            result = LoadedRecognizer(name, recognizer)
        except PinelError as error:
            result = LoadedRecognizer(name, problem=error)
        with self._lock:
            if number == self._n_started:  # else a newer one is being loaded
                self._result = result
        self._notify()
