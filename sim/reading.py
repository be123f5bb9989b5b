"""Reading a world document: all of its faults, or the world. Never raises for what a document contains."""

import json
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from itertools import islice
from typing import Any, TypeVar

from pydantic import ValidationError

from sim.document import MAX_BYTES, MAX_TITLE, WorldDocument
from sim.floor import paint_from_document, zone_from_document
from sim.placement import Parts, misplaced
from sim.world import World, box_from_document, wall_from_document, world_from_document
from sim.world_faults import Path, Placed, WorldFault, placed, placed_error

T = TypeVar("T")
MAX_FAULTS = 100
_LONE_SURROGATE = re.compile("[\ud800-\udfff]")
_LISTS = ("walls", "boxes", "zones", "floor")
_ORDER = ("pinel_world", "name", "title", "size_m", "start", *_LISTS)


@dataclass(frozen=True, slots=True)
class WorldReading:
    """Outcome of reading a world document.

    Attributes:
        world: what the simulator needs, None with faults.
        document: the document in its normal form (defaults filled in, keys in one order), None with faults.
        faults: what is wrong, in the order of the document; the first hundred.
    """

    world: World | None
    document: dict[str, Any] | None
    faults: tuple[WorldFault, ...] = ()


def read_world(source: Any, *, robot_radius_m: float) -> WorldReading:
    """Reads a document given as JSON text, as bytes or as parsed data; a robot of that radius must fit its start."""
    if isinstance(source, str | bytes):
        source = _parsed(source)
    elif isinstance(source, dict):
        source = _of_bearable_size(source)
    if isinstance(source, WorldFault):
        return WorldReading(None, None, (source,))
    if not isinstance(source, dict):
        return WorldReading(None, None, (WorldFault("not_a_world"),))
    source, odd = _with_known_keys(source)
    document = _without_nulls(source)
    model, unsound = _validated(document)
    unsound = [*odd, *unsound]
    if len(unsound) > MAX_FAULTS:
        return WorldReading(None, None, _in_order(unsound))
    parts = _sound_parts(document, {path[:2] for path, _ in unsound if path})
    # there may be as many as pairs of walls
    found = [*unsound, *islice(misplaced(parts, robot_radius_m), MAX_FAULTS)]
    if found or model is None:
        return WorldReading(None, None, _in_order(found))
    normal = model.model_dump(mode="json", by_alias=True)
    return WorldReading(world_from_document(normal), normal)


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
    ):  # not UTF-8, a number of thousands of digits, or a nest of brackets
        return WorldFault("world_syntax", params={"line": 1, "column": 1})


def _of_bearable_size(document: dict[Any, Any]) -> Any:
    try:
        size = len(json.dumps(document, separators=(",", ":")))
    except (
        TypeError,
        ValueError,
        RecursionError,
    ):  # no JSON, or a nest: told by what is wrong with its parts
        return document
    return document if size <= MAX_BYTES else _too_large(size)


def _too_large(size: int) -> WorldFault:
    return WorldFault("world_too_large", params={"value": size, "max": MAX_BYTES})


def _with_known_keys(document: dict[Any, Any]) -> tuple[dict[str, Any], list[Placed]]:
    """The document without keys that are no text, for which nothing else of it would be looked at."""
    kept = {key: value for key, value in document.items() if _is_text(key)}
    odd = [repr(key)[:MAX_TITLE] for key in document if not _is_text(key)]
    return kept, [placed((), "world_unknown_key", name=name) for name in odd[: MAX_FAULTS + 1]]


def _is_text(key: Any) -> bool:
    return isinstance(key, str) and not _LONE_SURROGATE.search(key)


def _without_nulls(document: dict[str, Any]) -> dict[str, Any]:
    """The document and its entries without keys that are null: those say as much as if they were absent."""
    kept = {key: value for key, value in document.items() if value is not None}
    for name in _LISTS:
        if isinstance(kept.get(name), list):
            kept[name] = [_entry(entry) for entry in kept[name]]
    return kept


def _entry(entry: Any) -> Any:
    if not isinstance(entry, dict):
        return entry
    return {key: value for key, value in entry.items() if value is not None}


def _validated(document: dict[str, Any]) -> tuple[WorldDocument | None, list[Placed]]:
    try:
        return WorldDocument.model_validate(document), []
    except ValidationError as error:
        errors = error.errors(include_url=False)[: MAX_FAULTS + 1]
        return None, [placed_error(document, found) for found in errors]


def _sound_parts(document: dict[str, Any], unsound: set[Path]) -> Parts:
    """What is sound in itself, so that faults of places are told beside those of other parts."""

    def is_sound(name: str) -> bool:
        return name in document and not any(path[0] == name for path in unsound)

    def entries(name: str, read: Callable[[dict[str, Any]], T]) -> dict[int, T]:
        if name not in document or (name,) in unsound:
            return {}
        listed = enumerate(document[name])
        return {i: read(entry) for i, entry in listed if (name, i) not in unsound}

    start = document.get("start")
    return Parts(
        size_m=tuple(document["size_m"]) if is_sound("size_m") else None,
        start=(start["x_m"], start["y_m"]) if start and is_sound("start") else None,
        walls=entries("walls", wall_from_document),
        boxes=entries("boxes", box_from_document),
        zones=entries("zones", zone_from_document),
        floor=entries("floor", paint_from_document),
    )


def _in_order(found: Iterable[Placed]) -> tuple[WorldFault, ...]:
    in_order = sorted(found, key=lambda placed: _rank(placed[0]))
    return tuple(fault for _, fault in in_order[:MAX_FAULTS])


def _rank(path: Path) -> tuple[int, int]:
    """What is missing as a whole comes first, keys that no world has last."""
    if not path:
        return -1, -1
    first = _ORDER.index(path[0]) if path[0] in _ORDER else len(_ORDER)
    return first, path[1] if len(path) > 1 and isinstance(path[1], int) else -1
