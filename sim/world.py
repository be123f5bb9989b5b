"""Worlds: walls, boxes and a start, as JSON. Metres and degrees in the file, in the world's own frame."""

import json
import math
import re
from dataclasses import dataclass
from functools import cache
from importlib import resources
from typing import Any

DEFAULT_WORLD = "empty_room"
_NAME = re.compile(r"[a-z0-9_]{1,64}\Z")


class WorldError(Exception):
    """A world that cannot be used: `code` and `params` choose the words shown."""

    def __init__(self, code: str, **params: object) -> None:
        super().__init__(f"{code} {params}")
        self.code = code
        self.params: dict[str, object] = params


@dataclass(frozen=True, slots=True)
class Wall:
    """A thin wall between two points, in metres."""

    start: tuple[float, float]
    end: tuple[float, float]


@dataclass(frozen=True, slots=True)
class Box:
    """A rectangular obstacle: centre and size in metres, turned by `angle_rad`."""

    center: tuple[float, float]
    size: tuple[float, float]
    angle_rad: float = 0.0

    def corners(self) -> list[tuple[float, float]]:
        """The four corners in metres, counterclockwise."""
        (cx, cy), (w, h) = self.center, self.size
        cos, sin = math.cos(self.angle_rad), math.sin(self.angle_rad)
        offsets = ((-w / 2, -h / 2), (w / 2, -h / 2), (w / 2, h / 2), (-w / 2, h / 2))
        return [(cx + cos * dx - sin * dy, cy + sin * dx + cos * dy) for dx, dy in offsets]


@dataclass(frozen=True, slots=True)
class World:
    """What surrounds the robot. `start` is (x in m, y in m, yaw in rad)."""

    name: str
    walls: tuple[Wall, ...]
    boxes: tuple[Box, ...]
    start: tuple[float, float, float]


def world_from_document(document: dict[str, Any]) -> World:
    """Reads a world document. Raises WorldError `world_invalid` naming the element."""
    try:
        start = document["start"]
        return World(
            name=str(document["name"]),
            walls=tuple(Wall(_point(w["from"]), _point(w["to"])) for w in document["walls"]),
            boxes=tuple(
                Box(_point(b["center"]), _point(b["size"]), math.radians(b.get("heading_deg", 0.0)))
                for b in document.get("boxes", ())
            ),
            start=(float(start["x_m"]), float(start["y_m"]), math.radians(start["heading_deg"])),
        )
    except (KeyError, TypeError, ValueError) as error:
        raise WorldError("world_invalid", world=document.get("name"), detail=str(error)) from error


def _point(pair: Any) -> tuple[float, float]:
    x, y = pair
    x, y = float(x), float(y)
    if not (math.isfinite(x) and math.isfinite(y)):
        raise ValueError(f"{pair} is not a point")
    return x, y


@cache
def _documents() -> dict[str, dict[str, Any]]:
    folder = resources.files("sim") / "worlds"
    files = sorted(entry.name for entry in folder.iterdir() if entry.name.endswith(".json"))
    documents = (json.loads((folder / name).read_text("utf-8")) for name in files)
    return {document["name"]: document for document in documents}


def list_worlds() -> list[dict[str, Any]]:
    """The documents of all worlds that ship, the default first, then by name."""
    return sorted(_documents().values(), key=lambda d: (d["name"] != DEFAULT_WORLD, d["name"]))


def world_document(name: str) -> dict[str, Any]:
    """The document of that world. Raises WorldError `unknown_world`, which lists the names there are."""
    if not _NAME.match(name) or name not in _documents():
        raise WorldError("unknown_world", value=name, allowed=[d["name"] for d in list_worlds()])
    return _documents()[name]


def load_world(name: str) -> World:
    """The world of that name, read. Raises WorldError `unknown_world` or `world_invalid`."""
    return world_from_document(world_document(name))
