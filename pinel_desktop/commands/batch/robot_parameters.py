"""Parameters of the simulated robot on the command line: `NAME=VALUE`."""

from collections.abc import Iterable

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import RobotParameters, robot_parameters_from


def chosen_parameters(typed: Iterable[str]) -> RobotParameters:
    """Reads parameters typed as `NAME=VALUE`.

    Raises PinelError `robot_parameter_unclear`; any error of `robot_parameters_from`.
    """
    values: dict[str, float] = {}
    for text in typed:
        name, value = name_and_value(text, values)
        values[name] = number_of(value, text)
    return robot_parameters_from(values)


def name_and_value(text: str, earlier: Iterable[str]) -> tuple[str, str]:
    """Splits `NAME=VALUE`. Raises PinelError `robot_parameter_unclear`, also for an earlier name."""
    name, equals, value = (part.strip() for part in text.partition("="))
    if not equals or not name or name in earlier:
        raise PinelError("robot_parameter_unclear", value=text)
    return name, value


def number_of(text: str, typed: str) -> float:
    """Reads a number that was typed in `typed`. Raises PinelError `robot_parameter_unclear`."""
    try:
        return float(text)
    except ValueError:
        raise PinelError("robot_parameter_unclear", value=typed) from None
