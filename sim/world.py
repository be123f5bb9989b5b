"""Worlds: walls, boxes, zones, painted floor and the start pose, in the world's frame.

Files use metres and degrees; the classes here use metres and radians.
"""

import json
import math
import re
from dataclasses import dataclass
from functools import cache
from importlib import resources
from typing import Any

from sim.floor import Paint, Zone, paint_from_document, point, zone_from_document

DEFAULT_WORLD = "empty_room"
_LESSONS = (
    *(DEFAULT_WORLD, "tic_tac_toe", "obstacles", "slalom", "maze", "lines", "pushing"),
    *("neighbourhood", "corridor", "colour_mat", "city_block", "slalom_gates"),
)
DEFAULT_BOX_MASS_KG = 2.0
WALL_RADIUS_M = 0.01
# limits of movable boxes: a thinner or lighter box would visibly penetrate walls and the robot
MIN_MOVABLE_SIDE_M = 0.05
MIN_MOVABLE_KG, MAX_MOVABLE_KG = 0.5, 20.0
_NAME = re.compile(r"[a-z0-9_]{1,64}\Z")


class WorldError(Exception):
    """An invalid or unknown world; `code` selects the message, `params` are its placeholders' values."""

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
    """A rectangular obstacle: centre and size in metres, rotated by `angle_rad`. The robot can push a movable box."""

    center: tuple[float, float]
    size: tuple[float, float]
    angle_rad: float = 0.0
    movable: bool = False
    mass_kg: float = DEFAULT_BOX_MASS_KG

    def corners(self) -> list[tuple[float, float]]:
        """Returns the four corners in metres, counterclockwise."""
        (cx, cy), (w, h) = self.center, self.size
        cos, sin = math.cos(self.angle_rad), math.sin(self.angle_rad)
        offsets = ((-w / 2, -h / 2), (w / 2, -h / 2), (w / 2, h / 2), (-w / 2, h / 2))
        return [(cx + cos * dx - sin * dy, cy + sin * dx + cos * dy) for dx, dy in offsets]


@dataclass(frozen=True, slots=True)
class World:
    """The robot's surroundings. `start` is (x in m, y in m, yaw in rad). Later zones and paints cover earlier ones."""

    name: str
    walls: tuple[Wall, ...]
    boxes: tuple[Box, ...]
    start: tuple[float, float, float]
    zones: tuple[Zone, ...] = ()
    floor: tuple[Paint, ...] = ()


def world_from_document(document: dict[str, Any]) -> World:
    """Reads a world document. Raises WorldError `world_invalid` naming the element.

    Optional: `zones`, named areas for the sensor `cell`, and `floor`, painted areas for the sensor `floor`. Each is a
    rectangle or a circle:

        {"name": "A", "center": [x, y], "size": [w, h], "heading_deg": 0}
        {"color": "green", "center": [x, y], "radius": r}
    """
    try:
        start = document["start"]
        return World(
            name=str(document["name"]),
            walls=tuple(wall_from_document(wall) for wall in document["walls"]),
            boxes=tuple(box_from_document(box) for box in document.get("boxes", ())),
            start=(*point((start["x_m"], start["y_m"])), math.radians(start["heading_deg"])),
            zones=tuple(zone_from_document(zone) for zone in document.get("zones", ())),
            floor=tuple(paint_from_document(area) for area in document.get("floor", ())),
        )
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        name = document.get("name") if isinstance(document, dict) else None
        raise WorldError("world_invalid", world=name, detail=str(error)) from error


def wall_from_document(entry: dict[str, Any]) -> Wall:
    """Reads `{"from", "to"}`. Raises KeyError, TypeError or ValueError."""
    return Wall(point(entry["from"]), point(entry["to"]))


def box_from_document(entry: dict[str, Any]) -> Box:
    """Reads `{"center", "size", "heading_deg", "movable", "mass_kg"}`. Raises KeyError, TypeError or ValueError."""
    return Box(
        center=point(entry["center"]),
        size=point(entry["size"]),
        angle_rad=math.radians(entry.get("heading_deg", 0.0)),
        movable=bool(entry.get("movable", False)),
        mass_kg=float(entry.get("mass_kg", DEFAULT_BOX_MASS_KG)),
    )


@cache
def _documents() -> dict[str, dict[str, Any]]:
    folder = resources.files("sim") / "worlds"
    files = sorted(entry.name for entry in folder.iterdir() if entry.name.endswith(".json"))
    documents = (json.loads((folder / name).read_text("utf-8")) for name in files)
    return {document["name"]: {"title": document["name"], **document} for document in documents}


def list_worlds() -> list[dict[str, Any]]:
    """Returns the documents of all shipped worlds: the worlds of lessons in their order, then the others by name.

    Their files have no title. The program has titles in every language; here the name stands for it.
    """
    return sorted(_documents().values(), key=lambda document: _rank(document["name"]))


def _rank(name: str) -> tuple[int, str]:
    return (_LESSONS.index(name) if name in _LESSONS else len(_LESSONS)), name


def world_document(name: str) -> dict[str, Any]:
    """Returns the document of a shipped world. Raises WorldError `unknown_world`, which lists the known names."""
    if not _NAME.match(name) or name not in _documents():
        raise WorldError("unknown_world", value=name, allowed=[d["name"] for d in list_worlds()])
    return _documents()[name]


def load_world(name: str) -> World:
    """Reads a shipped world by its name. Raises WorldError `unknown_world` or `world_invalid`."""
    return world_from_document(world_document(name))
