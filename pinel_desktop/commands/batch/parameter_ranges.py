"""Ranges of parameters of the simulated robot on the command line: `NAME=LOW:HIGH`."""

from collections.abc import Iterable

from pinel_desktop.commands.batch.robot_parameters import name_and_value, number_of
from pinel_desktop.errors import PinelError
from pinel_desktop.robot import RobotParameters, robot_parameters_from
from pinel_desktop.sweep.variation import ParameterRange


def chosen_ranges(typed: Iterable[str], fixed: RobotParameters) -> tuple[ParameterRange, ...]:
    """Reads ranges of parameters typed as `NAME=LOW:HIGH`.

    Args:
        fixed: parameters that have a value already.

    Raises:
        PinelError: `robot_range_unclear`; any error of `robot_parameters_from`.
    """
    ranges: dict[str, ParameterRange] = {}
    for text in typed:
        try:
            name, value = name_and_value(text, {**fixed.changes, **ranges})
            low, high = (number_of(part, text) for part in value.split(":"))
        except (PinelError, ValueError):  # ValueError: not two numbers
            raise PinelError("robot_range_unclear", value=text) from None
        for bound in (low, high):
            robot_parameters_from({name: bound})
        if low > high:
            raise PinelError("robot_range_unclear", value=text)
        ranges[name] = ParameterRange(name, low, high)
    return tuple(ranges.values())
