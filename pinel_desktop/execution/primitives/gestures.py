"""Capturing a gesture, setting its result."""

from pinel_desktop.events.model import CaptureStarted, GestureResult
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.primitives.base import instant, timed
from pinel_desktop.execution.requests import Routine
from pinel_desktop.program.model import ClassifyGestures, SetGestureResult


@timed("classify_gestures", "timeout")
def classify_gestures(context: RunContext, command: ClassifyGestures, timeout: float) -> Routine:
    """Waits for a result; "" after the timeout."""
    gestures = context.sources.gestures
    gestures.begin()  # before anybody hears of it: an answer may come at once
    context.emit(CaptureStarted(command.block, timeout))
    try:
        for _ in range(max(1, round(timeout * TICK_HZ))):
            yield None
            result = gestures.poll()
            if result is not None:
                break
        else:
            result = ""
    finally:
        gestures.cancel()
    context.gesture_result = result
    context.emit(GestureResult(result, "capture"))
    return None


@instant("set_gesture_result", "result")
def set_gesture_result(context: RunContext, _command: SetGestureResult, result: str) -> None:
    if context.gesture_result != result:
        context.gesture_result = result
        context.unreported.add("result")
