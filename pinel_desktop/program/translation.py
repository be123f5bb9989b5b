"""From what pydantic says of a document to faults a pupil can act on."""

from collections.abc import Callable, Sequence
from typing import Any

from pydantic_core import ErrorDetails

from pinel_desktop.program import model
from pinel_desktop.program.faults import Fault
from pinel_desktop.program.limits import MAX_TEXT

Path = tuple[str | int, ...]

_RANGE_ERRORS = ("greater_than", "greater_than_equal", "less_than", "less_than_equal")
_WRONG_TYPE = {
    "float_type": "number",
    "int_type": "whole_number",
    "int_from_float": "whole_number",
    "bool_type": "boolean",
    "string_type": "text",
    "list_type": "list",
    "dict_type": "object",
    "model_type": "object",
    "model_attributes_type": "object",
}
_SIMPLE = {
    "unknown_expression": "unknown_expression",
    "finite_number": "not_finite",
    "string_unicode": "text_not_unicode",
    "union_tag_not_found": "missing_action",
}


def pointer(path: Sequence[str | int]) -> str:
    """The JSON pointer (RFC 6901) of a path of keys and indices."""
    return "".join("/" + str(part).replace("~", "~0").replace("/", "~1") for part in path)


def path_of_error(document: Any, error: ErrorDetails) -> Path:
    """The error's place in the document: pydantic's location without the names of union members in it."""
    path: list[str | int] = []
    value = document
    for part in error["loc"]:
        inside = isinstance(value, dict) and part in value
        if inside or (isinstance(value, list) and isinstance(part, int) and part < len(value)):
            path.append(part)
            value = value[part]
    return tuple(path)


def fault_from_error(document: Any, path: Path, error: ErrorDetails, *, bare: bool) -> Fault:
    """The fault for one error. In a bare list the pointer counts from the list."""
    code, params = _code_and_params(error, path)
    shown = path[1:] if bare else path
    return Fault(code, pointer(shown), _block_at(document, path), params)


def _block_at(document: Any, path: Path) -> str | None:
    """Id of the innermost block around a place."""
    block: str | None = None
    value = document
    for part in path:
        value = value[part]
        found = value.get("block") if isinstance(value, dict) else None
        block = found if isinstance(found, str) else block
    return block


def _code_and_params(error: ErrorDetails, path: Path) -> tuple[str, dict[str, object]]:
    kind = error["type"]
    if kind in _RANGE_ERRORS:
        return _out_of_range(error, path)
    if kind in _WRONG_TYPE:
        return f"wrong_type_{_WRONG_TYPE[kind]}", {"name": _last_key(path)}
    if kind in _SIMPLE:
        return _SIMPLE[kind], {"name": _last_key(path)}
    special = _SPECIAL.get(kind)
    return special(error, path) if special else (kind, dict(error.get("ctx", {})))


def _missing(error: ErrorDetails, _path: Path) -> tuple[str, dict[str, object]]:
    name = str(error["loc"][-1])
    return ("missing_condition" if name == "condition" else "missing_parameter"), {"name": name}


def _unknown_action(error: ErrorDetails, _path: Path) -> tuple[str, dict[str, object]]:
    return "unknown_action", {"value": error["ctx"]["tag"], "allowed": model.action_names()}


def _wrong_value(error: ErrorDetails, path: Path) -> tuple[str, dict[str, object]]:
    return "wrong_value", {"name": _last_key(path), "value": _shown(error["input"])}


_SPECIAL: dict[str, Callable[[ErrorDetails, Path], tuple[str, dict[str, object]]]] = {
    "missing": _missing,
    "extra_forbidden": lambda error, _: ("unknown_key", {"name": str(error["loc"][-1])}),
    "union_tag_invalid": _unknown_action,
    "string_too_long": lambda _, path: (
        "text_too_long",
        {"name": _last_key(path), "max": MAX_TEXT},
    ),
    "too_long": lambda _, __: ("functions_not_supported", {}),
    "literal_error": _wrong_value,
}


def _out_of_range(error: ErrorDetails, path: Path) -> tuple[str, dict[str, object]]:
    name = _last_key(path)
    low, high = _RANGES[name]
    return f"{name}_out_of_range", {"value": error["input"], "min": low, "max": high}


def _ranges() -> dict[str, tuple[object, object]]:
    """Parameter name -> (least, greatest), from the models' own bounds."""
    ranges: dict[str, tuple[object, object]] = {}
    for command in model.COMMANDS:
        for name, field in command.model_fields.items():
            low = [getattr(m, "ge", getattr(m, "gt", None)) for m in field.metadata]
            high = [getattr(m, "le", getattr(m, "lt", None)) for m in field.metadata]
            bounds = [next((b for b in side if b is not None), None) for side in (low, high)]
            if None not in bounds:
                ranges[name] = (bounds[0], bounds[1])
    return ranges


_RANGES = _ranges()


def _last_key(path: Path) -> str:
    return next((part for part in reversed(path) if isinstance(part, str)), "")


def _shown(value: object) -> object:
    return value if isinstance(value, str | int | float | bool) else type(value).__name__
