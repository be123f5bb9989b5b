"""Capturing a gesture, setting its result."""

from collections.abc import Iterator

from pinel_desktop.events.model import CaptureStarted, GestureResult
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.primitives.base import instant, timed
from pinel_desktop.program.model import ClassifyGestures, SetGestureResult


@timed("classify_gestures")
def classify_gestures(context: RunContext, command: ClassifyGestures) -> Iterator[None]:
    """Waits for a result; "" after the timeout."""
    context.gestures.begin()  # before anybody hears of it: an answer may come at once
    context.emit(CaptureStarted(command.block, command.timeout))
    try:
        for _ in range(max(1, round(command.timeout * TICK_HZ))):
            yield
            result = context.gestures.poll()
            if result is not None:
                break
        else:
            result = ""
    finally:
        context.gestures.cancel()
    context.gesture_result = result
    context.emit(GestureResult(result, "capture"))


@instant("set_gesture_result")
def set_gesture_result(context: RunContext, command: SetGestureResult) -> None:
    if context.gesture_result != command.result:
        context.gesture_result = command.result
        context.result_unreported = True
