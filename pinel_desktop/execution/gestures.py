"""Where gesture results come from, as the executor sees it."""

from collections.abc import Iterable
from typing import Protocol


class GestureSource(Protocol):
    """Recognises one gesture at a time; a camera, a person at the page or a list."""

    def begin(self) -> None:
        """A capture begins; earlier answers are forgotten."""

    def poll(self) -> str | None:
        """The result ("" when nothing was recognised), or None while there is none yet."""
        ...

    def cancel(self) -> None:
        """The capture is over, answered or not."""


class ScriptedGestures:
    """Results given beforehand, one per capture, on the next tick; "" when they run out."""

    def __init__(self, results: Iterable[str] = ()) -> None:
        self._results = iter(results)

    def begin(self) -> None:
        return

    def poll(self) -> str | None:
        return next(self._results, "")

    def cancel(self) -> None:
        return


class AnsweredGestures:
    """Results given by a person while the capture runs; safe to answer from another thread."""

    def __init__(self) -> None:
        self._open = False
        self._answer: str | None = None

    def begin(self) -> None:
        self._answer, self._open = None, True

    def answer(self, result: str) -> None:
        """Answers the running capture; without one it says nothing."""
        if self._open:
            self._answer = result

    def poll(self) -> str | None:
        return self._answer

    def cancel(self) -> None:
        self._open = False
