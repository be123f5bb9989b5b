"""Values of the language: numbers (always doubles), texts, booleans, and lists of these."""

import math
import re
from typing import Any

from pinel_desktop.execution.failure import RunFailureError
from pinel_desktop.program.limits import MAX_TEXT
from pinel_desktop.program.operators import ValueType

Value = bool | float | str | list[Any]

_KINDS: dict[type, ValueType] = {bool: "boolean", float: "number", str: "text", list: "list"}
_NUMBER = re.compile(r"[+-]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)\Z")
# doubles represent every integer up to here
_EXACT = 2.0**53
_DIGITS, _ALL_DIGITS = 12, 16
_PLAIN_FROM = 1e-6


def kind(value: Value) -> ValueType:
    """Name of a value's type in the language."""
    return _KINDS[value.__class__]


def literal(value: Any) -> Value:
    """The value of a document's literal: integers become doubles, lists are copied."""
    if value.__class__ is int:
        return float(value)
    if value.__class__ is list:
        return [literal(item) for item in value]
    known: Value = value
    return known


def same(left: Value, right: Value) -> bool:
    """Equality of the language: false between different types, in lists too."""
    if left.__class__ is not right.__class__:
        return False
    if isinstance(left, list) and isinstance(right, list):
        types = map(type, left), map(type, right)
        return len(left) == len(right) and left == right and all(map(_is, *types))
    return left == right


def _is(left: type, right: type) -> bool:
    return left is right


def fold_case(value: Value) -> Value:
    """The value for comparison with a gesture result, which ignores case."""
    return value.casefold() if isinstance(value, str) else value


def position_of(items: list[Any], target: Value) -> int:
    """Returns the position, from 1, of the first equal item, else 0.

    Ignores case, because typed and signed texts differ in it.
    """
    if not isinstance(target, str):
        return next((i for i, item in enumerate(items, 1) if same(item, target)), 0)
    folded = target.casefold()  # never shorter than the text
    for i, item in enumerate(items, 1):
        if isinstance(item, str) and len(item) <= len(folded) and item.casefold() == folded:
            return i
    return 0


def display_text(value: Value, name: str) -> str:
    """A value as text, equal in all human languages: `3`, `0.5`, `true`, `1, 2, 3` for a list.

    Raises RunFailureError `text_too_long` with `name`.
    """
    if isinstance(value, list):
        return join(value, name, between=", ")
    if isinstance(value, bool):
        return "true" if value else "false"
    return value if isinstance(value, str) else number_text(value)


def join(values: list[Any], name: str, between: str = "") -> str:
    """The concatenated texts of values. Raises RunFailureError `text_too_long` with `name`."""
    parts: list[str] = []
    room = MAX_TEXT
    for value in values:
        parts.append(display_text(value, name))
        room -= len(parts[-1]) + (len(between) if len(parts) > 1 else 0)
        if room < 0:
            raise RunFailureError("text_too_long", name=name, max=MAX_TEXT)
    return between.join(parts)


def number_text(value: float) -> str:
    """A number with 12 digits (16 if it has more before the point), without trailing zeros.

    Only huge and tiny numbers have exponents.
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
    """Converts typed text: a number if it has the form of one, with a point or a comma, otherwise a text."""
    text = text.encode("utf-8", "replace").decode("utf-8")  # lone surrogates cannot be stored
    trimmed = text.strip()
    if not _NUMBER.match(trimmed):
        return text
    number = float(trimmed.replace(",", "."))
    return number if math.isfinite(number) else text


def plain(value: Value) -> Any:
    """A value as JSON data: integers without a decimal point."""
    if isinstance(value, list):
        return [plain(item) for item in value]
    if isinstance(value, float) and value.is_integer() and abs(value) < _EXACT:
        return int(value)
    return value


def size(value: Value) -> int:
    """Memory that a value counts as: characters of a text; items of a list and their characters."""
    if isinstance(value, str):
        return len(value)
    if isinstance(value, list):
        return len(value) + sum(len(item) for item in value if item.__class__ is str)
    return 0
