"""Tables of commands and sensors of docs/program-document.md and docs/python-text.md."""

import json
from typing import Any, get_args

from pinel_desktop.program.base import defaults
from pinel_desktop.program.command import CommandBase, action_of, parameters_of
from pinel_desktop.program.expressions import ParameterSpec
from pinel_desktop.program.model import COMMANDS, Branch
from pinel_desktop.program.python_text.forms import SENSOR_CALLS
from pinel_desktop.program.sensors import SENSORS, Sensor
from pinel_desktop.program.signatures import choices_of, parameter_spec


def commands_of_the_document() -> list[str]:
    """Columns: action, parameters with bounds, meaning."""
    return _table(
        ("action", "parameters", "what the robot does"),
        [(f"`{action_of(one)}`", _parameters(one), _description(one)) for one in COMMANDS],
    )


def commands_in_python() -> list[str]:
    """Columns: Python form, action, meaning."""
    return _table(
        ("Python", "command", "what it does"),
        [(f"`{one.python}`", f"`{action_of(one)}`", _in_python(one)) for one in COMMANDS],
    )


def sensors_of_the_document() -> list[str]:
    """Columns: form in a document, value."""
    return _table(
        ("form", "value"),
        [(f"`{json.dumps(_node(one))}`", _value(one)) for one in SENSORS.values()],
    )


def sensors_in_python() -> list[str]:
    """Columns: Python form, sensor, value."""
    return _table(
        ("Python", "expression", "what it is"),
        [(f"`{_python(one)}`", f"`{one.name}`", _value(one)) for one in SENSORS.values()],
    )


def _table(titles: tuple[str, ...], rows: list[tuple[str, ...]]) -> list[str]:
    lines = [" | ".join(row) for row in (titles, *rows)]
    return [f"| {lines[0]} |", "|---" * len(titles) + "|", *(f"| {line} |" for line in lines[1:])]


def _description(model: type[CommandBase]) -> str:
    """The docstring as a sentence fragment."""
    text = (model.__doc__ or "").strip().removesuffix(".")
    return text[:1].lower() + text[1:]


def _in_python(model: type[CommandBase]) -> str:
    specs = {name: parameter_spec(kind) for name, kind in parameters_of(model).items()}
    units = [f"`{name}` in {spec.unit}" for name, spec in specs.items() if spec and spec.unit]
    return f"{_description(model)}; {', '.join(units)}" if units else _description(model)


def _parameters(model: type[CommandBase]) -> str:
    without = defaults(model)
    return ", ".join(
        " ".join(filter(None, (f"`{name}`", _type_text(kind), _without(name, without))))
        for name, kind in parameters_of(model).items()
    )


def _type_text(annotation: Any) -> str:
    """Returns the type of a parameter as text; "" if its name implies the type."""
    spec = parameter_spec(annotation)
    if spec is not None:
        return _bounds(spec)
    if annotation is bool:
        return "true or false"
    if list[Branch] in get_args(annotation):
        return "(list of `condition` and `commands`)"
    return _or(choices_of(annotation))


def _or(choices: tuple[str, ...]) -> str:
    *first, last = choices or ("",)
    return f"{', '.join(first)} or {last}" if first else last


def _bounds(spec: ParameterSpec) -> str:
    if spec.choices:
        return _or(spec.choices)
    if spec.gt is not None:
        upper = "" if spec.le is None else f", up to {spec.le:g}"
        return f"above {spec.gt:g}{upper} {spec.unit}".strip()
    if spec.ge is not None and spec.le is not None:
        return f"{spec.ge:g} to {spec.le:.0f} {spec.unit}".strip()
    return spec.unit or spec.type


def _without(name: str, defaults_: dict[str, Any]) -> str:
    """Default of a parameter, as text."""
    if name not in defaults_:
        return ""
    value = defaults_[name]
    empty = value is None or value in ([], {})
    shown = "none" if empty else f"{value:g}" if isinstance(value, float) else str(value).lower()
    return f"({shown} without it)"


def _node(sensor: Sensor) -> dict[str, Any]:
    argument = sensor.argument
    return {"sensor": sensor.name} | ({argument.name: argument.start} if argument else {})


def _python(sensor: Sensor) -> str:
    form = SENSOR_CALLS.get(sensor.name)
    return form.example if form else f"robot.{sensor.name}"


def _value(sensor: Sensor) -> str:
    """Description, unit and argument of a sensor."""
    measured = f"{sensor.description} ({sensor.unit})" if sensor.unit else sensor.description
    argument = sensor.argument
    if argument is None:
        return measured
    bounds = f"{argument.low:g} to {argument.high:g} {argument.unit}".strip()
    asked = _or(tuple(f'"{one}"' for one in argument.choices)) or bounds
    return f"{measured}; `{argument.name}` {asked}"
