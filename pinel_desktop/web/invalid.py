"""What pydantic says of a body or a query, as something a person can act on."""

from collections.abc import Iterable
from typing import get_args

from pydantic import ValidationError
from pydantic.fields import FieldInfo

from pinel_desktop.web.models import Body

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
    """The code of the words for the first thing that is wrong, and what fills them."""
    first = error.errors(include_url=False, include_context=False, include_input=False)[0]
    if not first["loc"]:
        return "invalid_request_body", {"where": ""}
    where = str(first["loc"][0])
    params: dict[str, object] = {"where": where, "problem": first["type"]}
    # a place within the value is a member of a union: the one field that takes an object or a list
    kind = "document" if len(first["loc"]) > 1 else _KINDS.get(first["type"])
    field = _field(error.title, where)
    if field is not None:
        params |= _limits(field)
    return (f"invalid_request_{kind}" if kind else "invalid_request"), params


def _field(title: str, name: str) -> FieldInfo | None:
    models = {model.__name__: model for model in Body.__subclasses__()}
    return models[title].model_fields.get(name) if title in models else None


def _limits(field: FieldInfo) -> dict[str, object]:
    """Least and greatest value or length, and the allowed values, of those that the field has."""
    found = {
        "min": _first(getattr(limit, "ge", None) for limit in field.metadata),
        "max": _first(
            getattr(limit, "le", getattr(limit, "max_length", None)) for limit in field.metadata
        ),
        "allowed": [value for value in get_args(field.annotation) if isinstance(value, str)],
    }
    return {name: _exact(value) for name, value in found.items() if value not in (None, [])}


def _exact(value: object) -> object:
    """Large whole numbers as text, for words that would round them."""
    return str(value) if isinstance(value, int) and abs(value) >= 10**10 else value


def _first(values: Iterable[object]) -> object:
    return next((value for value in values if value is not None), None)
