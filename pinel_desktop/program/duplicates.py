"""Keys that an object of a JSON text holds more than once. `json.loads` keeps the last value and says nothing.

Looking at each object while parsing makes parsing 1.7 times as long. `most_keys` is the cheap test before it: a colon
after a key follows a quote or white space, and it counts all such colons. If the parsed data hold as many keys, none
was lost. A string may hold such a colon too (`"a : b"`). Then the numbers differ, and `duplicate_keys` looks at each
object.
"""

import json
from collections import Counter
from collections.abc import Iterator
from typing import Any

from pinel_desktop.program.faults import Fault
from pinel_desktop.program.pointers import Finding, Path, pointer

_WHITE_SPACE = " \t\n\r"


def most_keys(text: str) -> int:
    """An upper bound of the number of keys in a JSON text, exact where no string holds a colon after `"` or a space."""
    return text.count('":') + sum(text.count(f"{s}:") for s in _WHITE_SPACE if s in text)


def decoded(text: str | bytes) -> str:
    """The text of JSON in bytes, in the encoding that `json.loads` finds. Raises ValueError for what is no text."""
    return (
        text if isinstance(text, str) else text.decode(json.detect_encoding(text), "surrogatepass")
    )


def duplicate_keys(text: str) -> list[Finding]:
    """A finding for each key that an object of a JSON text holds more than once, with the path of the object.

    Objects inside a value that was itself lost are not looked at. Raises what `json.loads` raises.
    """
    doubled: dict[int, tuple[dict[str, Any], list[str]]] = {}

    def made(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        kept = dict(pairs)
        if len(kept) != len(pairs):
            counts = Counter(name for name, _ in pairs)
            # the object is kept, so that no other gets its id
            doubled[id(kept)] = kept, [name for name, count in counts.items() if count > 1]
        return kept

    document = json.loads(text, object_pairs_hook=made)
    if not doubled:
        return []
    return [
        ("duplicate_key", path, {"name": name})
        for path, value in _objects(document)
        for name in doubled.get(id(value), (value, []))[1]
    ]


def duplicate_key_faults(text: str | bytes) -> list[Fault]:
    """The same as faults, for documents other than programs; none where the text is no JSON, which its reader says."""
    try:
        found = duplicate_keys(decoded(text))
    except (ValueError, RecursionError):
        return []
    return [Fault(code, pointer(path), params=params) for code, path, params in found]


def _objects(document: Any) -> Iterator[tuple[Path, dict[str, Any]]]:
    """All objects with their paths, in no order."""
    waiting: list[tuple[Path, Any]] = [((), document)]
    while waiting:
        path, value = waiting.pop()
        if isinstance(value, dict):
            yield path, value
            waiting += [((*path, key), child) for key, child in value.items()]
        elif isinstance(value, list):
            waiting += [((*path, i), child) for i, child in enumerate(value)]
