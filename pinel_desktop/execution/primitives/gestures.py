"""Gesture captures and the gesture result."""

from pinel_desktop.events.model import CaptureStarted, GestureResult
from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.primitives.base import instant, timed
from pinel_desktop.execution.primitives.waiting import wait_for_input
from pinel_desktop.execution.requests import Routine
from pinel_desktop.program.model import ClassifyGestures, SetGestureResult


@timed("classify_gestures", "timeout")
def classify_gestures(context: RunContext, command: ClassifyGestures, timeout: float) -> Routine:
    """Waits for the result of a capture; "" after the timeout (s)."""
    announcement = CaptureStarted(command.block, timeout)
    source = context.sources.gestures
    result = yield from wait_for_input(context, source, announcement, timeout_s=timeout)
    context.gesture_result = result or ""
    context.emit(GestureResult(context.gesture_result, "capture"))
    return None


@instant("set_gesture_result", "result")
def set_gesture_result(context: RunContext, _command: SetGestureResult, result: str) -> None:
    if context.gesture_result != result:
        context.gesture_result = result
        context.unreported.add("result")
