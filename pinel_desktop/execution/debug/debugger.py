"""Where a run holds: at a breakpoint, or after a step."""

from collections.abc import Callable
from typing import Any

from pinel_desktop.events.model import PauseCause
from pinel_desktop.execution.control import RunControl


class Debugger:
    """Asked before each command; says whether the run is to pause there.

    A step ends at the next command that begins: `into` anywhere, `over` not inside of functions that are called
    from here, `out` after the function that runs. The command at which the run was held begins when it goes on.

    Args:
        depth: how many functions run at this moment.

    Attributes:
        cause: why the run holds, or will with the next pause.
        n_begun: how many commands have begun.
    """

    def __init__(self, control: RunControl, depth: Callable[[], int]) -> None:
        self._control, self._depth = control, depth
        self._depth_of_pause = 0
        self._is_held = False
        self.cause: PauseCause = "person"
        self.n_begun = 0

    def holds(self, command: Any) -> bool:
        """Whether the run pauses before this command; asks the control for the pause."""
        control = self._control
        if (
            self._is_held
            or control.stop_requested  # wins over a pause; a replay, which has no breakpoints, does the same
            or (control.step is None and not control.breakpoints and control.hold_at is None)
        ):
            self._is_held = False
            self.n_begun += 1
            return False
        if control.hold_at is not None and self.n_begun == control.hold_at[0]:
            cause, control.hold_at = control.hold_at[1], None
            self._hold(cause)
        elif command.block is not None and command.block in control.breakpoints:
            self._hold("breakpoint")
        elif self._step_is_over():
            self._hold("step")
        self.n_begun += not self._is_held
        return self._is_held

    def paused(self) -> None:
        """The run stands: steps are counted from here."""
        self._depth_of_pause = self._depth()

    def resumed(self) -> None:
        """The run goes on; the next pause is a person's unless a command holds it."""
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

    def _hold(self, cause: PauseCause) -> None:
        self._is_held = True
        self.cause = cause
        self._control.step = None
        self._control.pause()
