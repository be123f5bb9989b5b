"""The Python form of each command and expression, for reading and writing; docs/python-text.md describes them.

The forms of commands and sensors derive from their models and rows.
"""

import keyword
from dataclasses import dataclass
from typing import Any, Literal

from pinel_desktop.program.base import defaults
from pinel_desktop.program.command import CommandBase, action_of, parameters_of
from pinel_desktop.program.model import COMMANDS as COMMAND_MODELS
from pinel_desktop.program.operators import OPERATORS
from pinel_desktop.program.sensors import SENSORS, Argument
from pinel_desktop.program.signatures import choices_of, parameter_spec


@dataclass(frozen=True, slots=True)
class Parameter:
    """A parameter of a command.

    Attributes:
        keyword: written as a keyword argument, such as `timeout=5`.
        optional: may be omitted.
        default: value that is not written.
        written_as: value that is written if the document omits the parameter.
        literal: must be a literal text, or True or False; expressions are not allowed.
        placeholder: value used if a literal cannot be read, so that the rest can be checked.
        metres: a literal number is written with a decimal point, such as `1.0`.
    """

    name: str
    keyword: bool = False
    optional: bool = False
    default: object = None
    written_as: object = None
    literal: Literal["text", "boolean"] | None = None
    placeholder: object = None
    metres: bool = False


@dataclass(frozen=True, slots=True)
class Form:
    """A call such as `robot.turn(90)`; messages show the example."""

    example: str
    parameters: tuple[Parameter, ...] = ()


_METRES = ("m", "m/s")


def _parameter(name: str, annotation: Any, defaults: dict[str, Any]) -> Parameter:
    """The form of a field of a command's model. Optional and boolean parameters are keyword arguments."""
    optional, default = name in defaults, defaults.get(name)
    choices = choices_of(annotation)
    is_boolean = annotation is bool
    spec = parameter_spec(annotation)
    return Parameter(
        name,
        keyword=optional or is_boolean,
        optional=optional,
        default=default if is_boolean else None,
        written_as=None if is_boolean else default,
        literal="boolean" if is_boolean else "text" if choices else None,
        placeholder=None if optional else is_boolean or next(iter(choices), None),
        metres=spec is not None and spec.unit in _METRES,
    )


def _form(model: type[CommandBase]) -> Form:
    without = defaults(model)
    return Form(
        model.python,
        tuple(_parameter(name, kind, without) for name, kind in parameters_of(model).items()),
    )


_FORMS = {action_of(model): _form(model) for model in COMMAND_MODELS}
# commands written as `robot.NAME(...)`
COMMANDS = {action: form for action, form in _FORMS.items() if form.example.startswith("robot.")}
ASK = Form(_FORMS["ask"].example, _FORMS["ask"].parameters[:1])


def _sensor_form(name: str, argument: Argument) -> Form:
    literal: Literal["text"] | None = "text" if argument.choices else None
    start = f'"{argument.start}"' if argument.choices else argument.start
    return Form(f"robot.{name}({start})", (Parameter(argument.name, literal=literal),))


# sensors written as calls; the others are `robot.NAME`
SENSOR_CALLS = {
    name: _sensor_form(name, sensor.argument)
    for name, sensor in SENSORS.items()
    if sensor.argument is not None
}
MEASURES = tuple(name for name in SENSORS if name not in SENSOR_CALLS)
# what captures have read: attribute of the robot -> value of the document's key "gesture"
CAPTURED = {"gesture_result": "result", "number_shown": "number"}

# precedence of operators, from the lowest
OR, AND, NOT, COMPARISON, SUM, PRODUCT, SIGN, POWER, ATOM = range(9)
PRECEDENCE: dict[str, int] = {
    "or": OR,
    "and": AND,
    "not": NOT,
    **dict.fromkeys(("==", "!=", "<", "<=", ">", ">="), COMPARISON),
    **dict.fromkeys(("+", "-"), SUM),
    **dict.fromkeys(("*", "/", "%"), PRODUCT),
    "**": POWER,
}

# operators written as calls, such as `min(1, x)`
FUNCTIONS = tuple(name for name in OPERATORS if name.isidentifier() and name not in PRECEDENCE)
# names that have a meaning in these texts
RESERVED = frozenset(keyword.kwlist) | {"robot", "range", "steps"} | frozenset(FUNCTIONS)

# functions of standard Python, and their equivalents here
EQUIVALENTS = {
    "print": 'robot.say("...")',
    "input": 'x = robot.ask("...")',
    "len": "length(x)",
    "str": 'join("x = ", x)',
    "int": "round(x)",
    "float": "x",
    "sum": "x = x + 1",
    "pow": "x ** 2",
    "sleep": "robot.wait(1)",
    "randint": "random_int(1, 6)",
    "random": "random_int(1, 6)",
}
