"""Parser of world documents: returns the world, or all faults. No content of a document raises an error."""

import json
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from itertools import islice
from typing import Any, TypeVar

from pydantic import ValidationError

from sim.document import MAX_BYTES, MAX_TITLE, WorldDocument
from sim.floor import paint_from_document, zone_from_document
from sim.placement import Parts, placement_faults
from sim.world import World, box_from_document, wall_from_document, world_from_document
from sim.world_faults import LocatedFault, Path, WorldFault, fault_of_error, located

T = TypeVar("T")
MAX_FAULTS = 100
_LONE_SURROGATE = re.compile("[\ud800-\udfff]")
_LISTS = ("walls", "boxes", "zones", "floor", "prints")
_ORDER = ("pinel_world", "name", "title", "size_m", "start", *_LISTS[:-1], "ground", "prints")


@dataclass(frozen=True, slots=True)
class WorldParseResult:
    """Result of reading a world document.

    Attributes:
        world: the world for the simulator; None with faults.
        document: the document in normal form (defaults filled in, keys in a fixed order); None with faults.
        faults: the first hundred faults, in the order of the document.
    """

    world: World | None
    document: dict[str, Any] | None
    faults: tuple[WorldFault, ...] = ()


def read_world(source: Any, *, robot_radius_m: float) -> WorldParseResult:
    """Reads a document given as JSON text, bytes or parsed data. A robot of `robot_radius_m` must fit at the start."""
    if isinstance(source, str | bytes):
        source = _parsed(source)
    elif isinstance(source, dict):
        source = _within_size(source)
    if isinstance(source, WorldFault):
        return WorldParseResult(None, None, (source,))
    if not isinstance(source, dict):
        return WorldParseResult(None, None, (WorldFault("not_a_world"),))
    source, unknown_keys = _with_known_keys(source)
    document = _without_nulls(source)
    model, invalid = _validated(document)
    invalid = [*unknown_keys, *invalid]
    if len(invalid) > MAX_FAULTS:
        return WorldParseResult(None, None, _in_order(invalid))
    parts = _valid_parts(document, {path[:2] for path, _ in invalid if path})
    # limited, because the number of faults can reach the number of pairs of walls
    found = [*invalid, *islice(placement_faults(parts, robot_radius_m), MAX_FAULTS)]
    if found or model is None:
        return WorldParseResult(None, None, _in_order(found))
    normal = model.model_dump(mode="json", by_alias=True)
    return WorldParseResult(world_from_document(normal), normal)


def _parsed(text: str | bytes) -> Any:
    if len(text) > MAX_BYTES:
        return _too_large(len(text))
    try:
        return json.loads(text)
    except json.JSONDecodeError as error:
        return WorldFault("world_syntax", params={"line": error.lineno, "column": error.colno})
    except (
        ValueError,
        RecursionError,
    ):  # not UTF-8, a number with thousands of digits, or deep nesting
        return WorldFault("world_syntax", params={"line": 1, "column": 1})


def _within_size(document: dict[Any, Any]) -> Any:
    try:
        size = len(json.dumps(document, separators=(",", ":")))
    except (
        TypeError,
        ValueError,
        RecursionError,
    ):  # not JSON, or deep nesting: the validation reports the fault
        return document
    return document if size <= MAX_BYTES else _too_large(size)


def _too_large(size: int) -> WorldFault:
    return WorldFault("world_too_large", params={"value": size, "max": MAX_BYTES})


def _with_known_keys(document: dict[Any, Any]) -> tuple[dict[str, Any], list[LocatedFault]]:
    """Returns the document without keys that are no valid text, and a fault for each of these keys.

    Pydantic would stop at such a key and report no other fault.
    """
    known = {key: value for key, value in document.items() if _is_text(key)}
    unknown_keys = [repr(key)[:MAX_TITLE] for key in document if not _is_text(key)]
    return known, [
        located((), "world_unknown_key", name=name) for name in unknown_keys[: MAX_FAULTS + 1]
    ]


def _is_text(key: Any) -> bool:
    return isinstance(key, str) and not _LONE_SURROGATE.search(key)


def _without_nulls(document: dict[str, Any]) -> dict[str, Any]:
    """Returns the document without null values, also in its lists' entries: null means absent."""
    present = {key: value for key, value in document.items() if value is not None}
    for name in _LISTS:
        if isinstance(present.get(name), list):
            present[name] = [_entry(entry) for entry in present[name]]
    return present


def _entry(entry: Any) -> Any:
    if not isinstance(entry, dict):
        return entry
    return {key: value for key, value in entry.items() if value is not None}


def _validated(document: dict[str, Any]) -> tuple[WorldDocument | None, list[LocatedFault]]:
    try:
        return WorldDocument.model_validate(document), []
    except ValidationError as error:
        errors = error.errors(include_url=False)[: MAX_FAULTS + 1]
        return None, [fault_of_error(document, found) for found in errors]


def _valid_parts(document: dict[str, Any], invalid: set[Path]) -> Parts:
    """Returns the valid elements, so that placement faults are reported together with invalid elements."""

    def is_valid(name: str) -> bool:
        return name in document and not any(path[0] == name for path in invalid)

    def entries(name: str, read: Callable[[dict[str, Any]], T]) -> dict[int, T]:
        if name not in document or (name,) in invalid:
            return {}
        listed = enumerate(document[name])
        return {i: read(entry) for i, entry in listed if (name, i) not in invalid}

    start = document.get("start")
    return Parts(
        size_m=tuple(document["size_m"]) if is_valid("size_m") else None,
        start=(start["x_m"], start["y_m"]) if start and is_valid("start") else None,
        walls=entries("walls", wall_from_document),
        boxes=entries("boxes", box_from_document),
        zones=entries("zones", zone_from_document),
        floor=entries("floor", paint_from_document),
    )


def _in_order(found: Iterable[LocatedFault]) -> tuple[WorldFault, ...]:
    in_order = sorted(found, key=lambda fault: _rank(fault[0]))
    return tuple(fault for _, fault in in_order[:MAX_FAULTS])


def _rank(path: Path) -> tuple[int, int]:
    """Returns the sort key of a fault: missing top-level keys first, unknown keys last."""
    if not path:
        return -1, -1
    first = _ORDER.index(path[0]) if path[0] in _ORDER else len(_ORDER)
    return first, path[1] if len(path) > 1 and isinstance(path[1], int) else -1
