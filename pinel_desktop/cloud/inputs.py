"""What the robots of a cloud read: the signs and answers of a mission's case, or those of a run before."""

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from pinel_desktop.activities import Activity
from pinel_desktop.activities.commands import commands_of
from pinel_desktop.errors import PinelError
from pinel_desktop.runs.fixed_inputs import FixedInputs

_READING = frozenset({"classify_gestures", "read_number", "ask"})


def inputs_of(
    document: Mapping[str, Any],
    activity: Activity | None,
    recorded: Callable[[], Iterable[Mapping[str, Any]]] | None,
) -> FixedInputs:
    """Returns the inputs of all robots of a cloud.

    Args:
        activity: the mission with the case of the cloud only; None without one.
        recorded: reads the events of the run before; None without one.

    Raises:
        PinelError: `cloud_needs_inputs` for a program that reads something while neither case nor run gives it;
            `run_damaged`.
    """
    case = activity.cases[0] if activity else None
    if case and (case.gestures or case.answers):
        return FixedInputs(tuple(case.gestures), tuple(case.answers))
    if not any(command.action in _READING for command in commands_of(document)):
        return FixedInputs()
    if recorded is None:
        raise PinelError("cloud_needs_inputs")
    return FixedInputs.of_run(recorded())
