"""The end of an open run's program, at which the run waits for more commands."""

from collections.abc import Callable
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.stack import ProgramStack
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import STANDSTILL

MOVED_BY_HAND_M = 0.02


def await_commands(
    stack: ProgramStack,
    context: RunContext,
    control: RunControl,
    let_time_pass: Callable[[], None],
    *,
    simulated: bool,
) -> bool:
    """Waits for more commands and appends them to the program; returns False when no more will come.

    Stop ends the wait, too, because no command is cut short. In a simulator nothing changes during the wait and
    nothing is reported, so that the run equals a run of the whole program.

    Raises:
        PinelError: `invalid_program`; the app has read the commands before.
    """
    before = context.pose
    while (more := control.next_commands()) is None:
        if control.stop_requested or not control.is_open:
            return False
        let_time_pass()
    if not simulated:
        if context.pose.distance_to(before) > MOVED_BY_HAND_M:
            context.reference_lost = True
        context.command = context.driving or STANDSTILL
    stack.extend(_read(more))
    return True


def _read(commands: list[Any]) -> list[Any]:
    reading = read_document({"pinel_ir": 1, "commands": commands})
    if reading.program is None:
        raise PinelError("invalid_program", count=len(reading.faults))
    return reading.program.commands
