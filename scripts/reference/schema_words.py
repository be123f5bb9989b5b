"""JSON schemas as text, for Markdown tables."""

import json
from collections.abc import Callable, Mapping, Sequence
from typing import Any

Schema = Mapping[str, Any]
Link = Callable[[str], str]

_PLAIN = {
    "string": "text",
    "integer": "whole number",
    "number": "number",
    "boolean": "true or false",
    "null": "null",
}


def kind(schema: Schema, link: Link) -> str:
    """Type of a value as text.

    Args:
        link: returns the text for a named schema.
    """
    if "$ref" in schema:
        return link(schema["$ref"].rpartition("/")[2])
    if "const" in schema:
        return _literal(schema["const"])
    if "enum" in schema:
        return " or ".join(map(_literal, schema["enum"]))
    options = schema.get("anyOf") or schema.get("oneOf")
    if options:
        return " or ".join(dict.fromkeys(kind(option, link) for option in options))
    if schema.get("type") == "array":
        return _array(schema, link)
    if schema.get("type") == "object":
        return _object(schema, link)
    return _PLAIN.get(str(schema.get("type")), "any value")


def _literal(value: object) -> str:
    return f"`{json.dumps(value)}`"


def _array(schema: Schema, link: Link) -> str:
    if "prefixItems" in schema:
        return f"list of {len(schema['prefixItems'])} numbers"
    return f"list of ({kind(schema.get('items', {}), link)})"


def _object(schema: Schema, link: Link) -> str:
    values = schema.get("additionalProperties")
    if isinstance(values, dict) and values:
        return f"object of ({kind(values, link)})"
    return "object"


def field_table(schema: Schema, link: Link, leaving_out: Sequence[str] = ()) -> list[str]:
    """Table of an object's fields, as lines; empty without fields."""
    needed = schema.get("required", ())
    rows = [
        f"| `{name}`{'' if name in needed else ' (optional)'} | {kind(field, link)} | {about(field)} |"
        for name, field in schema.get("properties", {}).items()
        if name not in leaving_out
    ]
    return ["| field | type | meaning |", "|---|---|---|", *rows, ""] if rows else []


def about(field: Schema) -> str:
    """Description, limits and default of a field."""
    limits = [] if "prefixItems" in field else [_limit(field, name) for name in _LIMITS]
    given = field.get("default")
    default = [f"{_literal(given)} when left out"] if given is not None else []
    description = str(field.get("description", "")).rstrip(".")
    return "; ".join(part for part in (description, *limits, *default) if part)


_LIMITS = {
    "minimum": "at least {}",
    "maximum": "at most {}",
    "maxLength": "at most {} characters",
    "maxItems": "at most {}",
}


def _limit(field: Schema, name: str) -> str:
    options = (field, *field.get("anyOf", ()))
    found = next((option[name] for option in options if name in option), None)
    return "" if found is None else _LIMITS[name].format(found)
