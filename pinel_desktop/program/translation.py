"""From what pydantic says of a document to faults a pupil can act on."""

from collections.abc import Sequence
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
    kind, name, context = error["type"], str(error["loc"][-1]), error.get("ctx", {})
    if kind in _RANGE_ERRORS:
        return _out_of_range(error, path)
    if kind in _WRONG_TYPE:
        return f"wrong_type_{_WRONG_TYPE[kind]}", {"name": _last_key(path)}
    if kind in _SIMPLE:
        return _SIMPLE[kind], {"name": _last_key(path)}
    if kind == "missing":
        return ("missing_condition" if name == "condition" else "missing_parameter"), {"name": name}
    if kind == "extra_forbidden":
        return "unknown_key", {"name": name}
    if kind == "union_tag_invalid":
        return "unknown_action", {"value": context.get("tag"), "allowed": model.action_names()}
    if kind == "string_too_long":
        return "text_too_long", {"name": _last_key(path), "max": MAX_TEXT}
    if kind == "too_long":
        return "functions_not_supported", {}
    if kind == "literal_error":
        return "wrong_value", {"name": name, "value": _shown(error["input"])}
    return kind, dict(context)


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
