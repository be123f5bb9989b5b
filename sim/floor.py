"""What lies on a floor: named zones and painted areas, and which of them is at a point."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal, Protocol, get_args

Color = Literal["black", "red", "orange", "yellow", "green", "blue", "purple", "white"]
COLORS: tuple[Color, ...] = get_args(Color)
BARE_FLOOR = "white"
MAX_NAME = 64
_FARTHEST_M = 10_000.0


class Shape(Protocol):
    """A part of the floor, in metres, in the world's frame."""

    def holds(self, x_m: float, y_m: float) -> bool:
        """Whether the point is in it or on its edge."""
        ...


@dataclass(frozen=True, slots=True)
class Disc:
    """A circle with its inside."""

    center: tuple[float, float]
    radius: float

    def holds(self, x_m: float, y_m: float) -> bool:
        return math.hypot(x_m - self.center[0], y_m - self.center[1]) <= self.radius


@dataclass(frozen=True, slots=True)
class Rectangle:
    """A rectangle of width and height `size`, turned by `angle_rad`."""

    center: tuple[float, float]
    size: tuple[float, float]
    angle_rad: float = 0.0

    def holds(self, x_m: float, y_m: float) -> bool:
        dx, dy = x_m - self.center[0], y_m - self.center[1]
        cos, sin = math.cos(self.angle_rad), math.sin(self.angle_rad)
        ahead, left = cos * dx + sin * dy, cos * dy - sin * dx
        return abs(ahead) <= self.size[0] / 2 and abs(left) <= self.size[1] / 2


@dataclass(frozen=True, slots=True)
class Zone:
    """A named part of the floor, such as a cell of a board."""

    name: str
    shape: Shape


@dataclass(frozen=True, slots=True)
class Paint:
    """A part of the floor with a colour of COLORS."""

    color: str
    shape: Shape


def zone_at(zones: Sequence[Zone], x_m: float, y_m: float) -> str:
    """The name of the zone at a point, the last one where several overlap; "" outside of all."""
    return next((zone.name for zone in reversed(zones) if zone.shape.holds(x_m, y_m)), "")


def color_at(paints: Sequence[Paint], x_m: float, y_m: float) -> str:
    """The colour at a point, that of the last area where several overlap; white where nothing is painted."""
    return next((area.color for area in reversed(paints) if area.shape.holds(x_m, y_m)), BARE_FLOOR)


def zone_from_document(entry: dict[str, Any]) -> Zone:
    """Reads `{"name", "center", "size", "heading_deg"}` or `{"name", "center", "radius"}`. Raises ValueError."""
    name = entry["name"]
    if not isinstance(name, str) or not 1 <= len(name) <= MAX_NAME:
        raise ValueError(f"{name!r} is not a name for a zone")
    return Zone(name, _shape(entry))


def paint_from_document(entry: dict[str, Any]) -> Paint:
    """Reads `{"color", ...}` with a shape like a zone's. Raises ValueError."""
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
    """A pair of numbers that physics can bear. Raises ValueError or TypeError."""
    x, y = pair
    x, y = float(x), float(y)
    if not (abs(x) <= _FARTHEST_M and abs(y) <= _FARTHEST_M):  # so is what is no number
        raise ValueError(f"{pair} is not a point")
    return x, y
