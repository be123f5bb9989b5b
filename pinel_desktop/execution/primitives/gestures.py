"""Gesture captures and the gesture result."""

from pinel_desktop.events.model import CaptureStarted, GestureResult
from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.inputs import NO_CAPTURE
from pinel_desktop.execution.primitives.base import instant, timed
from pinel_desktop.execution.primitives.waiting import wait_for_input
from pinel_desktop.execution.requests import Routine
from pinel_desktop.program.model import ClassifyGestures, SetGestureResult


@timed("classify_gestures", "timeout")
def classify_gestures(context: RunContext, command: ClassifyGestures, timeout: float) -> Routine:
    """Waits for the result of a capture; no sign after the timeout (s)."""
    announcement = CaptureStarted(command.block, timeout)
    source = context.sources.gestures
    given = yield from wait_for_input(context, source, announcement, timeout_s=timeout)
    capture = given or NO_CAPTURE
    context.gesture_result = capture.label
    context.emit(
        GestureResult(capture.label, "capture", capture.by, capture.confidence, capture.second)
    )
    return None


@instant("set_gesture_result", "result")
def set_gesture_result(context: RunContext, _command: SetGestureResult, result: str) -> None:
    if context.gesture_result != result:
        context.gesture_result = result
        context.unreported.add("result")
