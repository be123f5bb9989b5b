"""Places in a document: paths, JSON pointers, enclosing blocks."""

from collections.abc import Iterable, Sequence
from typing import Any

from pinel_desktop.program.limits import MAX_NESTING

Path = tuple[str | int, ...]
# (code, path, params)
PathFault = tuple[str, Path, dict[str, object]]
# a level of a document is a key, or a key and an index; longer paths are certainly too deep
MAX_PATH = 2 * MAX_NESTING + 6


def pointer(path: Sequence[str | int]) -> str:
    """The JSON pointer (RFC 6901) of a path of keys and indices."""
    return "".join("/" + str(part).replace("~", "~0").replace("/", "~1") for part in path)


def value_at(document: Any, path: Path) -> Any:
    """The value at a path."""
    for part in path:
        document = document[part]
    return document


def has_path(document: Any, path: Path) -> bool:
    """True if the document has a value at the path."""
    try:
        value_at(document, path)
    except (LookupError, TypeError):
        return False
    return True


def block_at(document: Any, path: Path) -> str | None:
    """Id of the innermost block that contains the path; None without one."""
    block: str | None = None
    value = document
    for part in path:
        value = value[part]
        found = value.get("block") if isinstance(value, dict) else None
        block = found if isinstance(found, str) else block
    return block


def in_document_order(document: Any, paths: Iterable[Path]) -> list[Path]:
    """Sorts paths by their position in the document."""
    places: dict[int, dict[str, int]] = {}  # positions of the keys of each object, determined once
    return sorted(paths, key=lambda path: _rank(document, path, places))


def _rank(document: Any, path: Path, places: dict[int, dict[str, int]]) -> tuple[int, ...]:
    rank = []
    value = document
    for part in path:
        if isinstance(part, int):
            rank.append(part)
        else:
            if id(value) not in places:
                places[id(value)] = {key: place for place, key in enumerate(value)}
            rank.append(places[id(value)][part])
        value = value[part]
    return tuple(rank)
