"""Inputs of a run without the app: a camera answers its captures, a list its questions."""

from collections.abc import Callable, Iterable

from pinel_desktop.camera.client import Camera, CameraState
from pinel_desktop.events.model import CaptureStarted, Event, GestureResult, RunEnded, RunState
from pinel_desktop.events.stamp import EventStamp
from pinel_desktop.execution.inputs import Capture, PersonInput, ScriptedInputs

_READY_S = 20.0
_OF_INTEREST = (CaptureStarted, GestureResult, RunState, RunEnded)


class CameraInputs:
    """Owns a camera process for one run. Use as a context manager.

    Args:
        source: as `frames.open_reader` takes it.
        answers: answers to questions, in order.
        on_change: called with each new state of the camera.
    """

    is_live = True

    def __init__(
        self, source: str, answers: Iterable[str], on_change: Callable[[CameraState], None]
    ) -> None:
        self.gestures = PersonInput[Capture]()
        self.answers = ScriptedInputs(answers=answers).answers
        self._camera = Camera(source, lambda event: None, on_change, self._answer)

    def attach(self, control: object) -> Callable[[int, Event], None]:
        """Waits until signs can be recognised; gives what must observe the run."""
        self._camera.wait_until_ready(_READY_S)
        stamp = EventStamp("run")

        def observe(tick: int, event: Event) -> None:
            if isinstance(event, _OF_INTEREST):
                self._camera.observe(stamp.wire(tick, event))

        return observe

    def __enter__(self) -> "CameraInputs":
        self._camera.wake()
        return self

    def __exit__(self, *failure: object) -> None:
        self._camera.close()

    def _answer(self, _run: str, capture: Capture) -> None:
        self.gestures.answer(capture)
