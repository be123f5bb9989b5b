"""Inputs of `pinel run --camera`, without the app: a camera answers the captures, a list the questions."""

import math
import threading
from collections.abc import Callable, Iterable
from dataclasses import replace

from pinel_desktop.camera.address import check_address, check_recognizer
from pinel_desktop.camera.client import CameraClient, CameraState
from pinel_desktop.errors import PinelError
from pinel_desktop.events.event_sequencer import EventSequencer
from pinel_desktop.events.model import CaptureStarted, Event, GestureResult, RunEnded, RunState
from pinel_desktop.execution.inputs import Capture, PersonInput, ScriptedInputs

_READY_S = 20.0
_OPEN_S = 5.0  # timeout for opening the camera; then the run starts without it
# These problems mean a wrong address. A busy or dark camera may still become usable during the run.
WRONG_SOURCE = (
    "camera_missing",
    "camera_source_missing",
    "camera_source_unreadable",
    "camera_folder_empty",
)
# Codes that begin so prevent the run: other signs, or none, would be read than the person asked for.
WRONG_RECOGNIZER = ("recognizer_", "detector_")
_OF_INTEREST = (CaptureStarted, GestureResult, RunState, RunEnded)


class CameraInputs:
    """Supervises a camera process for one run. Use as a context manager.

    Args:
        source: address of the camera, as for `frames.open_reader`.
        recognizer: name of the recognizer of signs, as for `gestures.recognizers.open_recognizer`.
        answers: answers to questions, in order.
        on_change: called with each new state of the camera.
    """

    is_live = True

    def __init__(
        self,
        source: str,
        recognizer: str,
        answers: Iterable[str],
        on_change: Callable[[CameraState], None],
    ) -> None:
        self.gestures = PersonInput[Capture]()
        self.answers = ScriptedInputs(answers=answers).answers
        self._source, self._on_change = source, on_change
        self._camera = CameraClient(
            source, lambda event: None, self._change, self._answer, idle_end_s=math.inf
        )
        self._camera.set_recognizer(recognizer)
        self._is_tried = threading.Event()

    def attach(self, control: object) -> Callable[[int, Event], None]:
        """Returns the observer to which the run must report each event."""
        stamp = EventSequencer("run")

        def observe(tick: int, event: Event) -> None:
            if isinstance(event, _OF_INTEREST):
                self._camera.observe(stamp.wire(tick, event))

        return observe

    def __enter__(self) -> "CameraInputs":
        """Waits until signs can be recognised.

        Raises:
            PinelError: one of `WRONG_SOURCE`, or why the recognizer cannot be used, before the robot moves.
        """
        check_address(self._source)
        check_recognizer(self._camera.recognizer.name)
        try:
            self._open()
        except BaseException:
            self._camera.close()
            raise
        return self

    def __exit__(self, *failure: object) -> None:
        self._camera.close()

    def _open(self) -> None:
        self._camera.start()
        self._camera.wait_until_ready(_READY_S)
        recognizer = self._camera.wait_for_recognizer(_READY_S)
        if recognizer.problem:
            raise recognizer.problem
        if not recognizer.is_loaded:
            raise PinelError("recognizer_slow", name=recognizer.name)
        self._camera.switch_on()
        self._is_tried.wait(_OPEN_S)
        problem = self._as_typed(self._camera.state).problem
        if problem and problem.code in WRONG_SOURCE:
            raise problem

    def _change(self, state: CameraState) -> None:
        was_tried = self._is_tried.is_set()
        if state.mode in ("on", "failed"):
            self._is_tried.set()
        if was_tried or not (state.problem and state.problem.code in WRONG_SOURCE):
            self._on_change(self._as_typed(state))  # else `_open` raises the problem

    def _as_typed(self, state: CameraState) -> CameraState:
        """Returns the state with the camera number as typed: the page counts from 1, the option from 0."""
        if state.problem and "number" in state.problem.params:
            return replace(state, problem=PinelError(state.problem.code, number=self._source))
        return state

    def _answer(self, _run: str, capture: Capture) -> None:
        self.gestures.answer(capture)
