"""The table of all recognizers of signs.

To add one, write a class with the members of `recognizer.SignRecognizer`, and add a row to `_OPENERS`.
"""

from collections.abc import Callable
from pathlib import Path

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.letters import LANDMARKS, YOLO
from pinel_desktop.gestures.recognizer import SignRecognizer


def open_recognizer(name: str) -> SignRecognizer:
    """Opens a recognizer by its name: `landmarks`, or `yolo:FILE`.

    Raises:
        PinelError: `recognizer_unknown`, or why the recognizer or its file cannot be used.
    """
    kind, _, argument = name.partition(":")
    opener = _OPENERS.get(kind)
    if opener is None or bool(argument) != (kind != LANDMARKS):
        raise PinelError("recognizer_unknown", name=name)
    return opener(argument)


def _landmarks(_argument: str) -> SignRecognizer:
    from pinel_desktop.gestures.recognition import LandmarkRecognizer  # noqa: PLC0415 - loads networks

    return LandmarkRecognizer()


def _yolo(argument: str) -> SignRecognizer:
    from pinel_desktop.gestures.yolo.detector import open_detector  # noqa: PLC0415 - seldom used

    return open_detector(Path(argument))


_OPENERS: dict[str, Callable[[str], SignRecognizer]] = {LANDMARKS: _landmarks, YOLO: _yolo}
