"""Checks whether a text is JSON that every part of the program can read, without a parser that could fail.

Blockly nests each block in the one above it, with two levels of JSON for a block. A workspace may be thousands of
levels deep. The web server allows that depth; Python's own parser, which other parts use, does not.
"""

import json
import math
import re
from functools import lru_cache
from typing import Any

_PLAIN_DEPTH = 400  # Python's parser always allows this depth
_SHORT = 4_000  # characters
_MAX_DEPTH = 9_000  # below the web server's limit
_MAX_DIGITS = 4_300  # of an integer, the limit of Python's own parser
_BRACKETS = re.compile(r'"(?:[^"\\]|\\.)*"|([\[{])|([\]}])')
_TOKEN = re.compile(
    r'[ \t\n\r]*(?:(?P<string>"(?:[^"\\\x00-\x1f]|\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4}))*")'
    r"|(?P<scalar>-?(?:0|[1-9][0-9]*)(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?|true|false|null)|(?P<sign>[\[\]{},:])|(?P<end>$))"
)
_OPENING = {"{": "}", "[": "]"}


def parsed(text: str) -> Any:
    """Returns the value of JSON of ordinary depth, with finite numbers and each key once; None for other texts."""
    # short texts recur; large ones are not cached, to free their memory
    return _cached_read(text) if len(text) <= _SHORT else _read(text)


def is_deep(text: str) -> bool:
    """Returns whether the text may be too deep for Python's own parser."""
    return _is_deeper_than(text, _PLAIN_DEPTH)


def is_object(text: str) -> bool:
    """Returns True for a JSON object, which may be as deep as a workspace."""
    if not is_deep(text):
        return isinstance(parsed(text), dict)
    return not _is_deeper_than(text, _MAX_DEPTH) and _is_deep_object(text)


def _read(text: str) -> Any:
    if is_deep(text):
        return None
    try:
        return json.loads(
            text, parse_constant=_refused, parse_float=_finite, object_pairs_hook=_object
        )
    except (ValueError, RecursionError):
        return None


_cached_read = lru_cache(maxsize=512)(_read)


def _refused(name: str) -> Any:
    raise ValueError(name)


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    made = dict(pairs)
    return made if len(made) == len(pairs) else _refused("a key twice")


def _finite(text: str) -> float:
    value = float(text)
    return value if math.isfinite(value) else _refused(text)


def _is_deeper_than(text: str, limit: int) -> bool:
    if text.count("[") + text.count("{") <= limit:
        return False
    depth = deepest = 0
    for found in _BRACKETS.finditer(text):
        depth += (found[1] is not None) - (found[2] is not None)
        deepest = max(deepest, depth)
    return deepest > limit


def _is_deep_object(text: str) -> bool:
    """Checks the grammar of RFC 8259 with an explicit stack, as recursion would be too deep."""
    closings: list[str] = []
    awaited, place = "object", 0
    while awaited != "end":
        token = _TOKEN.match(text, place)
        if token is None:
            return False
        place = token.end()
        following = _after(token, awaited, closings)
        if following is None:
            return False
        awaited = following
    return text[place:].strip(" \t\n\r") == ""


def _after(token: re.Match[str], awaited: str, closings: list[str]) -> str | None:
    """Returns the token that must follow; None if this token is not allowed here."""
    sign = token["sign"]
    if (
        sign in _OPENING
        and awaited in ("object", "value", "value or ]")
        and not (awaited == "object" and sign != "{")
    ):
        closings.append(_OPENING[sign])
        return "key or }" if sign == "{" else "value or ]"
    if sign and sign in "]}":
        return _closed(sign, awaited, closings)
    if sign == ":":
        return "value" if awaited == ":" else None
    if sign == ",":
        following = "key" if closings and closings[-1] == "}" else "value"
        return following if awaited == ", or end" else None
    if token["string"] is not None and awaited in ("key", "key or }"):
        return ":"
    if token["end"] is not None or awaited not in ("value", "value or ]"):
        return None
    return ", or end" if token["string"] or _is_readable(token["scalar"]) else None


def _closed(sign: str, awaited: str, closings: list[str]) -> str | None:
    if (
        not closings
        or closings[-1] != sign
        or awaited not in (", or end", f"key or {sign}", f"value or {sign}")
    ):
        return None
    closings.pop()
    return ", or end" if closings else "end"


def _is_readable(scalar: str) -> bool:
    if scalar in ("true", "false", "null"):
        return True
    if scalar.lstrip("-").isdigit():
        return len(scalar.lstrip("-")) <= _MAX_DIGITS
    return math.isfinite(float(scalar))
