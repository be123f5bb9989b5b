"""Loads the chosen recognizer for the camera process, and says what became of it."""

from collections.abc import Sequence
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


def load_recognizer(name: str) -> LoadedRecognizer:
    """Loads a recognizer, as `open_recognizer` names it. May take seconds."""
    try:
        return LoadedRecognizer(name, None if name == LANDMARKS else open_recognizer(name))
    except PinelError as error:
        return LoadedRecognizer(name, problem=error)
