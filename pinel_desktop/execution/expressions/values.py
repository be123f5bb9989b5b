"""The values a program works with: numbers (always doubles), texts, booleans, and lists of those."""

import math
import re
from typing import Any

from pinel_desktop.execution.failure import RunFailureError
from pinel_desktop.program.limits import MAX_TEXT
from pinel_desktop.program.operators import ValueType

Value = bool | float | str | list[Any]

_KINDS: dict[type, ValueType] = {bool: "boolean", float: "number", str: "text", list: "list"}
_NUMBER = re.compile(r"[+-]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)\Z")
# up to here a double holds every whole number
_EXACT = 2.0**53
_DIGITS, _ALL_DIGITS = 12, 16
_PLAIN_FROM = 1e-6


def kind(value: Value) -> ValueType:
    """The type of a value, by the name it has in the language."""
    return _KINDS[value.__class__]


def literal(value: Any) -> Value:
    """A literal of a document as a value: whole numbers become doubles, lists are copied."""
    if value.__class__ is int:
        return float(value)
    if value.__class__ is list:
        return [literal(item) for item in value]
    known: Value = value
    return known


def same(left: Value, right: Value) -> bool:
    """Equality of the language: between different types always false, in lists too."""
    if left.__class__ is not right.__class__:
        return False
    if isinstance(left, list) and isinstance(right, list):
        types = map(type, left), map(type, right)
        return len(left) == len(right) and left == right and all(map(_is, *types))
    return left == right


def _is(left: type, right: type) -> bool:
    return left is right


def folded(value: Value) -> Value:
    """Gesture results are compared without regard to case: "b" is B."""
    return value.casefold() if isinstance(value, str) else value


def shown(value: Value, name: str) -> str:
    """A value as people read it, in every language the same: 3, 0.5, true, 1, 2, 3 for a list.

    Raises RunFailureError `text_too_long`, naming `name`.
    """
    if isinstance(value, list):
        return join(value, name, between=", ")
    if isinstance(value, bool):
        return "true" if value else "false"
    return value if isinstance(value, str) else shown_number(value)


def join(values: list[Any], name: str, between: str = "") -> str:
    """The shown values one after the other. Raises RunFailureError `text_too_long`, naming `name`."""
    parts: list[str] = []
    room = MAX_TEXT
    for value in values:
        parts.append(shown(value, name))
        room -= len(parts[-1]) + (len(between) if len(parts) > 1 else 0)
        if room < 0:
            raise RunFailureError("text_too_long", name=name, max=MAX_TEXT)
    return between.join(parts)


def shown_number(value: float) -> str:
    """A number in 12 digits (16 where it has more before the point), without trailing zeros.

    Exponents are for the huge and the tiny only.
    """
    if value.is_integer() and abs(value) < _EXACT:
        return str(int(value))
    digits = _ALL_DIGITS if 10.0 ** (_DIGITS - 1) <= abs(value) < _EXACT else _DIGITS
    text = f"{value:.{digits}g}"
    if "e" not in text or abs(value) < _PLAIN_FROM or abs(value) >= _EXACT:
        return text
    decimals = max(0, digits - 1 - math.floor(math.log10(abs(value))))
    plain = f"{float(text):.{decimals}f}"
    return plain.rstrip("0").rstrip(".") if "." in plain else plain


def from_answer(text: str) -> Value:
    """What a person typed: a number if it reads as one, with a point or a comma, else the text."""
    text = text.encode("utf-8", "replace").decode("utf-8")  # lone surrogates cannot be kept
    trimmed = text.strip()
    if not _NUMBER.match(trimmed):
        return text
    number = float(trimmed.replace(",", "."))
    return number if math.isfinite(number) else text


def plain(value: Value) -> Any:
    """A value for JSON: whole numbers without a decimal point."""
    if isinstance(value, list):
        return [plain(item) for item in value]
    if isinstance(value, float) and value.is_integer() and abs(value) < _EXACT:
        return int(value)
    return value


def size(value: Value) -> int:
    """How much memory a value counts as: a text by its characters, a list by its items and their characters."""
    if isinstance(value, str):
        return len(value)
    if isinstance(value, list):
        return len(value) + sum(len(item) for item in value if item.__class__ is str)
    return 0
