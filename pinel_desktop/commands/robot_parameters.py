"""Parameters of the simulated robot on the command line: `NAME=VALUE` and `NAME=LOW:HIGH`."""

from collections.abc import Iterable

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import RobotParameters, robot_parameters_from


def chosen_parameters(typed: Iterable[str]) -> RobotParameters:
    """Reads parameters typed as `NAME=VALUE`.

    Raises PinelError `robot_parameter_unclear`; any error of `robot_parameters_from`.
    """
    values: dict[str, float] = {}
    for text in typed:
        name, value = _name_and_value(text, values)
        values[name] = _number(value, text)
    return robot_parameters_from(values)


def _name_and_value(text: str, earlier: Iterable[str]) -> tuple[str, str]:
    name, equals, value = (part.strip() for part in text.partition("="))
    if not equals or not name or name in earlier:
        raise PinelError("robot_parameter_unclear", value=text)
    return name, value


def _number(text: str, typed: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise PinelError("robot_parameter_unclear", value=typed) from None
