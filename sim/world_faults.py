"""Faults of world documents (code, JSON pointer, parameters), and their translation from pydantic's errors."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, get_args

from pydantic_core import ErrorDetails

from sim.appearance import BoxKind, Ground, Print
from sim.floor import COLORS

Path = tuple[str | int, ...]
Params = dict[str, object]


@dataclass(frozen=True, slots=True)
class WorldFault:
    """One fault of a world document.

    Attributes:
        code: selects the message; its text is in the application.
        pointer: JSON pointer (RFC 6901) to the element.
        params: values of the message's placeholders; numbers of list elements count from 1.
    """

    code: str
    pointer: str = ""
    params: Params = field(default_factory=dict, hash=False)


LocatedFault = tuple[Path, WorldFault]


def located(path: Path, code: str, **params: object) -> LocatedFault:
    """Returns a fault together with its path."""
    return path, WorldFault(code, pointer(path), params)


def pointer(path: Path) -> str:
    """Returns the JSON pointer (RFC 6901) of a path of keys and indices."""
    return "".join("/" + str(part).replace("~", "~0").replace("/", "~1") for part in path)


def fault_of_error(document: Any, error: ErrorDetails) -> LocatedFault:
    """Translates one error of pydantic."""
    path = _path(document, error)
    name = next((part for part in reversed(path) if isinstance(part, str)), "")
    kind = error["type"]
    if kind in _CODES:
        return located(path, _CODES[kind], name=name)
    code, params = _SPECIAL.get(kind, _otherwise)(error, name)
    return located(path, code, **params)


def _path(document: Any, error: ErrorDetails) -> Path:
    """Returns the error's path in the document: pydantic's location without union tags and missing keys."""
    path: list[str | int] = []
    value = document
    for part in error["loc"]:
        inside = isinstance(value, dict) and part in value
        if inside or (isinstance(value, list) and isinstance(part, int) and part < len(value)):
            path.append(part)
            value = value[part]
    return tuple(path)


def _length(error: ErrorDetails, name: str) -> tuple[str, Params]:
    if name in _TOO_MANY:
        return _TOO_MANY[name], {"max": error["ctx"]["max_length"]}
    return "world_not_a_pair", {"name": name}


def _constant(error: ErrorDetails, name: str) -> tuple[str, Params]:
    if name == "pinel_world":
        return "world_version_unknown", {"value": _shown(error["input"])}
    if name == "color":
        return "unknown_color", {"value": _shown(error["input"]), "allowed": list(COLORS)}
    names = _APPEARANCE[str(error["loc"][0])]
    return "unknown_appearance", {"value": _shown(error["input"]), "allowed": list(get_args(names))}


def _name(error: ErrorDetails, name: str) -> tuple[str, Params]:
    if error["ctx"]["pattern"].startswith("^"):
        return "world_name_invalid", {"value": _shown(error["input"])}
    return "world_text_blank", {"name": name}


def _otherwise(error: ErrorDetails, name: str) -> tuple[str, Params]:
    """Fallback for all other kinds of errors: pydantic has about a hundred, and new releases add more."""
    return "world_value_wrong", {"name": name, "value": _shown(error["input"])}


def _shown(value: object) -> object:
    return value if isinstance(value, str | int | float) else type(value).__name__


_CODES = {
    "float_type": "wrong_type_number",
    "bool_type": "wrong_type_boolean",
    "string_type": "wrong_type_text",
    "list_type": "wrong_type_list",
    "model_type": "world_not_an_object",
    "model_attributes_type": "world_not_an_object",
    "finite_number": "not_finite",
    "string_unicode": "text_not_unicode",
    "union_tag_not_found": "world_title_invalid",
}
_APPEARANCE = {"ground": Ground, "prints": Print, "boxes": BoxKind}
_TOO_MANY = {
    "walls": "too_many_walls",
    "boxes": "too_many_boxes",
    "zones": "too_many_zones",
    "floor": "too_many_paints",
    "prints": "too_many_prints",
}
_SPECIAL: dict[str, Callable[[ErrorDetails, str], tuple[str, Params]]] = {
    "missing": lambda error, _: ("missing_parameter", {"name": str(error["loc"][-1])}),
    "extra_forbidden": lambda error, _: ("world_unknown_key", {"name": str(error["loc"][-1])}),
    "greater_than_equal": lambda error, name: (
        "world_value_too_small",
        {"name": name, "value": error["input"], "min": error["ctx"]["ge"]},
    ),
    "less_than_equal": lambda error, name: (
        "world_value_too_large",
        {"name": name, "value": error["input"], "max": error["ctx"]["le"]},
    ),
    "string_too_long": lambda error, name: (
        "text_too_long",
        {"name": name, "value": len(error["input"]), "max": error["ctx"]["max_length"]},
    ),
    "string_pattern_mismatch": _name,
    "literal_error": _constant,
    "world_version_unknown": _constant,
    "too_short": _length,
    "too_long": _length,
}
