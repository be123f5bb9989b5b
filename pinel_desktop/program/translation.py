"""Translates pydantic's errors into faults that a pupil can act on."""

from collections.abc import Callable
from typing import Any

from pydantic_core import ErrorDetails

from pinel_desktop.program import model
from pinel_desktop.program.faults import Fault
from pinel_desktop.program.limits import MAX_LIST, MAX_NAME, MAX_TEXT
from pinel_desktop.program.pointers import Path, block_at, pointer, value_at
from pinel_desktop.program.signatures import PARAMETER_SPECS, range_code

_RANGE_ERRORS = ("greater_than", "greater_than_equal", "less_than", "less_than_equal")
WRONG_TYPE = {
    "float_type": "number",
    "int_type": "whole_number",
    "int_from_float": "whole_number",
    "bool_type": "boolean",
    "string_type": "text",
    "list_type": "list",
    "dict_type": "object",
    "dataclass_type": "object",
    "model_attributes_type": "object",
}
# how pydantic names the literal of `expressions.ParameterSpec` in an error's location
_LITERAL_SCHEMA_NAMES = (
    "bool",
    "float",
    "constrained-",
    "str",
    "function-before[_whole",
    "literal[",
)
_SIMPLE = {
    "unknown_expression": "unknown_expression",
    "finite_number": "not_finite",
    "string_unicode": "text_not_unicode",
    "union_tag_not_found": "missing_action",
}


def path_of_error(document: Any, error: ErrorDetails) -> Path:
    """The error's path in the document: pydantic's location without names of union members."""
    path: list[str | int] = []
    value = document
    for part in error["loc"]:
        inside = isinstance(value, dict) and part in value
        if inside or (isinstance(value, list) and isinstance(part, int) and part < len(value)):
            path.append(part)
            value = value[part]
    return tuple(path)


def fault_from_error(document: Any, path: Path, error: ErrorDetails, *, bare: bool) -> Fault:
    """The fault for one error. `bare`: the pointer is relative to the bare list."""
    code, params = _code_and_params(error, path, document)
    return placed_fault(document, path, code, params, bare=bare)


def placed_fault(
    document: Any, path: Path, code: str, params: dict[str, object], *, bare: bool
) -> Fault:
    """A fault at a path of the document, with its block."""
    shown = path[1:] if bare else path
    return Fault(code, pointer(shown), block_at(document, path), params)


def relevant_errors(document: Any, errors: list[ErrorDetails]) -> list[tuple[Path, ErrorDetails]]:
    """Returns the errors that matter, with their paths.

    A parameter is a literal or an expression, and pydantic reports errors for both alternatives. Errors of the
    alternative that was not intended are dropped.
    """
    at_path: dict[Path, list[ErrorDetails]] = {}
    for error in errors:
        at_path.setdefault(path_of_error(document, error), []).append(error)
    meant = {path: _meant(value_at(document, path), found) for path, found in at_path.items()}
    around = {path[:length] for path in at_path for length in range(len(path))}
    for path, found in at_path.items():
        # not a literal where only literals are allowed, and no error inside
        if not meant[path] and path not in around:
            meant[path] = [{**found[0], "type": "unknown_expression"}]
    return [(path, error) for path, found in meant.items() for error in found]


def _meant(value: Any, errors: list[ErrorDetails]) -> list[ErrorDetails]:
    """The errors at one place that belong to the intended alternative."""
    types = [error for error in errors if _is_of_literal(error) and error["type"] in WRONG_TYPE]
    unknown = [error for error in errors if error["type"] == "unknown_expression"]
    others = [error for error in errors if error not in types and error not in unknown]
    if len(types) > 1:  # literals of several types are allowed
        return others or unknown
    if isinstance(value, dict):
        return [error for error in others if not _is_of_literal(error)] or unknown
    return types + others or unknown


def _is_of_literal(error: ErrorDetails) -> bool:
    """True if the error concerns one of the literal types that a parameter may have."""
    return bool(error["loc"]) and str(error["loc"][-1]).startswith(_LITERAL_SCHEMA_NAMES)


def _code_and_params(
    error: ErrorDetails, path: Path, document: Any
) -> tuple[str, dict[str, object]]:
    kind = error["type"]
    if kind in _RANGE_ERRORS:
        return _out_of_range(error, path, document)
    if kind in WRONG_TYPE:
        return f"wrong_type_{WRONG_TYPE[kind]}", {"name": _last_key(path)}
    if kind in _SIMPLE:
        return _SIMPLE[kind], {"name": _last_key(path)}
    special = _SPECIAL.get(kind)
    return special(error, path) if special else (kind, dict(error.get("ctx", {})))


def _missing(error: ErrorDetails, _path: Path) -> tuple[str, dict[str, object]]:
    name = str(error["loc"][-1])
    return ("missing_condition" if name == "condition" else "missing_parameter"), {"name": name}


def _unknown_action(error: ErrorDetails, _path: Path) -> tuple[str, dict[str, object]]:
    return "unknown_action", {"value": error["ctx"]["tag"], "allowed": model.action_names()}


def _too_long(limit: int, text: str, path: Path) -> tuple[str, dict[str, object]]:
    if limit == MAX_NAME:
        return "name_invalid", {"value": text, "max": MAX_NAME}
    return "text_too_long", {"name": _last_key(path), "value": len(text), "max": MAX_TEXT}


def _wrong_value(error: ErrorDetails, path: Path) -> tuple[str, dict[str, object]]:
    name, value = _last_key(path), _shown(error["input"])
    if name == "symbol":
        return "symbol_unknown", {"value": value}
    return "wrong_value", {"name": name, "value": value}


_SPECIAL: dict[str, Callable[[ErrorDetails, Path], tuple[str, dict[str, object]]]] = {
    "missing": _missing,
    "unexpected_keyword_argument": lambda error, _: (
        "unknown_key",
        {"name": str(error["loc"][-1])},
    ),
    "union_tag_invalid": _unknown_action,
    "string_too_long": lambda error, path: _too_long(
        error["ctx"]["max_length"], error["input"], path
    ),
    "string_pattern_mismatch": lambda error, _: (
        "name_invalid",
        {"value": error["input"], "max": MAX_NAME},
    ),
    "too_long": lambda error, path: (
        "list_too_long",
        {"name": _last_key(path), "value": error["ctx"]["actual_length"], "max": MAX_LIST},
    ),
    "literal_error": _wrong_value,
}


def _out_of_range(error: ErrorDetails, path: Path, document: Any) -> tuple[str, dict[str, object]]:
    """The bounds are in the model of the enclosing command or sensor."""
    name = _last_key(path)
    around = value_at(document, path[:-1])
    kind = around.get("action", around.get("sensor"))
    spec = PARAMETER_SPECS[kind, name]
    low = spec.ge if spec.gt is None else spec.gt
    params = {"value": error["input"], "min": low, "max": spec.le}
    return range_code(name, spec), params


def _last_key(path: Path) -> str:
    return next((part for part in reversed(path) if isinstance(part, str)), "")


def _shown(value: object) -> object:
    return value if isinstance(value, str | int | float | bool) else type(value).__name__
