"""Reports the variables, the call stack and the gesture result of a run."""

from typing import Any

from pinel_desktop.events.model import Watch
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.expressions.values import Value, plain
from pinel_desktop.execution.stack import ProgramStack

_PAUSE_TICKS = TICK_HZ // 5
_MAX_TEXT = 200
_MAX_ITEMS = 20
_MAX_CHARACTERS = 20_000
_CUT = "…"


class VariableWatch:
    """Reports changes, at most five times a second or on demand; for runs with an observer."""

    def __init__(self, context: RunContext, stack: ProgramStack) -> None:
        self._context, self._stack = context, stack
        self._due = 0
        self._reported = self._state()

    def _state(self) -> tuple[int, int, str, int]:
        context = self._context
        captured = (context.gesture_result, context.number_shown)
        return context.variables.version, self._stack.n_calls, *captured

    def report(self, *, now: bool = False) -> None:
        """Reports changes since the last report, when due or `now`."""
        context = self._context
        if (context.tick < self._due and not now) or (state := self._state()) == self._reported:
            return
        self._reported, self._due = state, context.tick + _PAUSE_TICKS
        calls = [call.copy() for call in self._stack.calls]
        shown = _cut(context.variables.visible())
        context.emit(Watch(shown, calls, context.gesture_result, context.number_shown))


def _cut(variables: dict[str, Value]) -> dict[str, Any]:
    """The variables for display; long texts and lists, and a long total, end in an ellipsis."""
    room = _MAX_CHARACTERS
    shown: dict[str, Any] = {}
    for name, value in variables.items():
        shown[name] = cut_value(value) if room > 0 else _CUT
        room -= len(str(shown[name])) + len(name)
    return shown


def cut_value(value: Value) -> Any:
    """A value for display, as plain data; long texts and lists end in an ellipsis."""
    if isinstance(value, str):
        return value if len(value) <= _MAX_TEXT else value[:_MAX_TEXT] + _CUT
    if isinstance(value, list):
        items = [cut_value(item) for item in value[:_MAX_ITEMS]]
        return [*items, _CUT] if len(value) > _MAX_ITEMS else items
    return plain(value)
