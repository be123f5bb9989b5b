"""Captures of signs and of numbers shown by hand, and the gesture result."""

from dataclasses import replace

from pinel_desktop.events.model import CaptureStarted, GestureResult
from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.inputs import NO_CAPTURE, NO_NUMBER, number_of
from pinel_desktop.execution.primitives.base import instant, timed
from pinel_desktop.execution.primitives.waiting import wait_for_input
from pinel_desktop.execution.requests import Routine
from pinel_desktop.program.model import ClassifyGestures, ReadNumber, SetGestureResult


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


@timed("read_number", "timeout")
def read_number(context: RunContext, command: ReadNumber, timeout: float) -> Routine:
    """Waits for a number shown by hand; `NO_NUMBER` after the timeout (s), and for a sign that is no number."""
    announcement = CaptureStarted(command.block, timeout, "number")
    source = context.sources.gestures
    given = yield from wait_for_input(context, source, announcement, timeout_s=timeout)
    capture = given or NO_CAPTURE
    context.number_shown = number_of(capture)
    if context.number_shown == NO_NUMBER:
        capture = replace(capture, label="")
    context.emit(
        GestureResult(
            capture.label, "capture", capture.by, capture.confidence, capture.second, "number"
        )
    )
    return None


@instant("set_gesture_result", "result")
def set_gesture_result(context: RunContext, _command: SetGestureResult, result: str) -> None:
    if context.gesture_result != result:
        context.gesture_result = result
        context.unreported.add("result")
