"""Pauses a run at breakpoints and after steps."""

from collections.abc import Callable
from typing import Any

from pinel_desktop.events.model import PauseCause
from pinel_desktop.execution.control import RunControl


class Debugger:
    """Decides before each command whether the run pauses there.

    A step ends at the next command that starts: with `into` anywhere, with `over` outside functions called from
    here, with `out` after the running function. The command before which the run paused starts on resume.

    Args:
        depth: number of functions on the stack.

    Attributes:
        cause: cause of the current or next pause.
        n_started: number of commands that have started.
    """

    def __init__(self, control: RunControl, depth: Callable[[], int]) -> None:
        self._control, self._depth = control, depth
        self._depth_of_pause = 0
        self._is_held = False
        self.cause: PauseCause = "person"
        self.n_started = 0

    def should_pause(self, command: Any) -> bool:
        """Whether the run pauses before this command; if so, requests the pause."""
        control = self._control
        if (
            self._is_held
            or control.stop_requested  # has priority; a replay, which has no breakpoints, behaves the same
            or (control.step is None and not control.breakpoints and control.pause_at is None)
        ):
            self._is_held = False
            self.n_started += 1
            return False
        if control.pause_at is not None and self.n_started == control.pause_at[0]:
            cause, control.pause_at = control.pause_at[1], None
            self._request_pause(cause)
        elif command.block is not None and command.block in control.breakpoints:
            self._request_pause("breakpoint")
        elif self._step_is_over():
            self._request_pause("step")
        self.n_started += not self._is_held
        return self._is_held

    def paused(self) -> None:
        """Records that the run has paused: the next step starts here."""
        self._depth_of_pause = self._depth()

    def resumed(self) -> None:
        """Records that the run has resumed: the cause of the next pause is a person, unless a command changes it."""
        self.cause = "person"

    def _step_is_over(self) -> bool:
        match self._control.step:
            case "into":
                return True
            case "over":
                return self._depth() <= self._depth_of_pause
            case "out":
                return self._depth() < self._depth_of_pause
        return False

    def _request_pause(self, cause: PauseCause) -> None:
        self._is_held = True
        self.cause = cause
        self._control.step = None
        self._control.pause()
