"""Duplicate keys in the objects of a JSON text, of which `json.loads` silently returns only the last.

Examining each object while parsing takes 1.7 times as long. `max_keys` is a cheap test before that: it counts all
colons after a quote or white space, which includes those after keys. If the parsed data have as many keys, there
are no duplicates. If not, a string may contain such a colon (`"a : b"`), and `duplicate_keys` examines each object.
"""

import json
from collections import Counter
from collections.abc import Iterator
from typing import Any

from pinel_desktop.program.faults import Fault
from pinel_desktop.program.pointers import Path, PathFault, pointer

_WHITE_SPACE = " \t\n\r"


def max_keys(text: str) -> int:
    """Upper bound of the number of keys in a JSON text; exact unless a string has a colon after a quote or space."""
    return text.count('":') + sum(text.count(f"{s}:") for s in _WHITE_SPACE if s in text)


def decoded(text: str | bytes) -> str:
    """Decodes JSON bytes in the encoding that `json.loads` detects. Raises ValueError for invalid bytes."""
    return (
        text if isinstance(text, str) else text.decode(json.detect_encoding(text), "surrogatepass")
    )


def duplicate_keys(text: str) -> list[PathFault]:
    """A finding for each duplicate key, with the path of its object.

    Objects inside a value that a duplicate replaced are not examined. Raises what `json.loads` raises.
    """
    duplicates: dict[int, tuple[dict[str, Any], list[str]]] = {}

    def made(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        mapping = dict(pairs)
        if len(mapping) != len(pairs):
            counts = Counter(name for name, _ in pairs)
            # holding a reference keeps the object's id unique
            duplicates[id(mapping)] = mapping, [name for name, count in counts.items() if count > 1]
        return mapping

    document = json.loads(text, object_pairs_hook=made)
    if not duplicates:
        return []
    return [
        ("duplicate_key", path, {"name": name})
        for path, value in _objects(document)
        for name in duplicates.get(id(value), (value, []))[1]
    ]


def duplicate_key_faults(text: str | bytes) -> list[Fault]:
    """`duplicate_keys` as faults, for other documents than programs; none for invalid JSON."""
    try:
        found = duplicate_keys(decoded(text))
    except (ValueError, RecursionError):
        return []
    return [Fault(code, pointer(path), params=params) for code, path, params in found]


def _objects(document: Any) -> Iterator[tuple[Path, dict[str, Any]]]:
    """Yields all objects with their paths, in no order."""
    waiting: list[tuple[Path, Any]] = [((), document)]
    while waiting:
        path, value = waiting.pop()
        if isinstance(value, dict):
            yield path, value
            waiting += [((*path, key), child) for key, child in value.items()]
        elif isinstance(value, list):
            waiting += [((*path, i), child) for i, child in enumerate(value)]
