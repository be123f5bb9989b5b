"""Translates pydantic's validation errors of bodies and queries into messages for people."""

from collections.abc import Iterable
from typing import get_args

from pydantic import BaseModel, ValidationError
from pydantic.fields import FieldInfo

from pinel_desktop.engine.commands import COMMANDS, LiveCommand
from pinel_desktop.web.models import RequestModel

_KINDS = {
    "missing": "missing",
    "extra_forbidden": "unknown",
    "string_type": "text",
    "string_unicode": "text",
    "string_too_long": "length",
    "literal_error": "choice",
    "dict_type": "object",
    "list_type": "object",
    "int_type": "number",
    "int_parsing": "number",
    "int_parsing_size": "number",
    "int_from_float": "number",
    "finite_number": "number",
    "greater_than_equal": "range",
    "less_than_equal": "range",
}


def first_problem(error: ValidationError) -> tuple[str, dict[str, object]]:
    """Returns code and parameters of the message for the first validation error."""
    first = error.errors(include_url=False, include_input=False)[0]
    loc = first["loc"]
    if first["type"].startswith("union_tag"):
        return "invalid_request_choice", {"where": "do", "allowed": list(COMMANDS)}
    if not loc:
        return "invalid_request_body", {"where": ""}
    model = _models().get(error.title)
    if error.title == LiveCommand.__name__:  # its error locations start with the command's name
        model, loc = COMMANDS[str(loc[0])], loc[1:]
    where = str(loc[0])
    params: dict[str, object] = {"where": where, "problem": first["type"]}
    # a longer location is inside a union of object and list, which only `document` is
    kind = "document" if len(loc) > 1 else _KINDS.get(first["type"])
    field = model.model_fields.get(where) if model else None
    if field is not None:
        params |= _limits(field)
    return (f"invalid_request_{kind}" if kind else "invalid_request"), params


def _models() -> dict[str, type[BaseModel]]:
    return {model.__name__: model for model in RequestModel.__subclasses__()}


def _limits(field: FieldInfo) -> dict[str, object]:
    """Returns the field's limits of value or length, and its allowed values, if any."""
    found = {
        "min": _first(getattr(limit, "ge", None) for limit in field.metadata),
        "max": _first(
            getattr(limit, "le", getattr(limit, "max_length", None)) for limit in field.metadata
        ),
        "allowed": [value for value in get_args(field.annotation) if isinstance(value, str)],
    }
    return {name: _exact(value) for name, value in found.items() if value not in (None, [])}


def _exact(value: object) -> object:
    """Converts large integers to text, because messages would round them."""
    return str(value) if isinstance(value, int) and abs(value) >= 10**10 else value


def _first(values: Iterable[object]) -> object:
    return next((value for value in values if value is not None), None)
