"""The floor: named zones and painted areas, and their look-up by point."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal, Protocol, get_args

Color = Literal["black", "red", "orange", "yellow", "green", "blue", "purple", "white"]
COLORS: tuple[Color, ...] = get_args(Color)
BARE_FLOOR = "white"
MAX_NAME = 64
_MAX_COORDINATE_M = 10_000.0


class Shape(Protocol):
    """An area of the floor, in metres, in the world's frame."""

    @property
    def center(self) -> tuple[float, float]: ...

    def contains(self, x_m: float, y_m: float) -> bool:
        """Returns whether the point is inside or on the edge."""
        ...


@dataclass(frozen=True, slots=True)
class Disc:
    """A filled circle; `radius` in metres."""

    center: tuple[float, float]
    radius: float

    def contains(self, x_m: float, y_m: float) -> bool:
        return math.hypot(x_m - self.center[0], y_m - self.center[1]) <= self.radius


@dataclass(frozen=True, slots=True)
class Rectangle:
    """A filled rectangle with width and height `size` (m), rotated by `angle_rad`."""

    center: tuple[float, float]
    size: tuple[float, float]
    angle_rad: float = 0.0

    def contains(self, x_m: float, y_m: float) -> bool:
        dx, dy = x_m - self.center[0], y_m - self.center[1]
        cos, sin = math.cos(self.angle_rad), math.sin(self.angle_rad)
        ahead, left = cos * dx + sin * dy, cos * dy - sin * dx
        return abs(ahead) <= self.size[0] / 2 and abs(left) <= self.size[1] / 2


@dataclass(frozen=True, slots=True)
class Zone:
    """A named area of the floor, such as a cell of a board."""

    name: str
    shape: Shape


@dataclass(frozen=True, slots=True)
class Paint:
    """A painted area of the floor; `color` is one of COLORS."""

    color: str
    shape: Shape


def zone_at(zones: Sequence[Zone], x_m: float, y_m: float) -> str:
    """Returns the name of the zone at a point (m, world's frame); the last one if zones overlap, "" outside all."""
    return next((zone.name for zone in reversed(zones) if zone.shape.contains(x_m, y_m)), "")


def color_at(paints: Sequence[Paint], x_m: float, y_m: float) -> str:
    """Returns the colour at a point (m, world's frame); of the last area if areas overlap, white on unpainted floor."""
    return next(
        (area.color for area in reversed(paints) if area.shape.contains(x_m, y_m)), BARE_FLOOR
    )


def zone_from_document(entry: dict[str, Any]) -> Zone:
    """Reads `{"name", "center", "size", "heading_deg"}` or `{"name", "center", "radius"}`. Raises ValueError."""
    name = entry["name"]
    if not isinstance(name, str) or not 1 <= len(name) <= MAX_NAME:
        raise ValueError(f"{name!r} is not a name for a zone")
    return Zone(name, _shape(entry))


def paint_from_document(entry: dict[str, Any]) -> Paint:
    """Reads `{"color", ...}` with the shape keys of a zone. Raises ValueError."""
    color = entry["color"]
    if color not in COLORS:
        raise ValueError(f"{color!r} is not one of {', '.join(COLORS)}")
    return Paint(color, _shape(entry))


def _shape(entry: dict[str, Any]) -> Shape:
    center = point(entry["center"])
    if "radius" in entry:
        return Disc(center, _length(entry["radius"]))
    width, height = entry["size"]
    angle_rad = math.radians(entry.get("heading_deg", 0.0))
    return Rectangle(center, (_length(width), _length(height)), angle_rad)


def _length(value: Any) -> float:
    length = float(value)
    if not 0.0 < length < math.inf:
        raise ValueError(f"{value} is not a length")
    return length


def point(pair: Any) -> tuple[float, float]:
    """Reads a pair of coordinates in m, each at most 10 km. Raises ValueError or TypeError."""
    x, y = pair
    x, y = float(x), float(y)
    if not (abs(x) <= _MAX_COORDINATE_M and abs(y) <= _MAX_COORDINATE_M):  # refuses NaN, too
        raise ValueError(f"{pair} is not a point")
    return x, y
