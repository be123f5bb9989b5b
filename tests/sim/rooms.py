"""Rooms for the tests of the simulator, and measures of overlap."""

import math
from collections.abc import Iterable
from typing import Any

from pinel_desktop.robot import PIONEER_3DX, RobotModel
from sim.simulator import Simulator
from sim.world import WALL_RADIUS_M, Box, World, world_from_document

HALF_M = 2.0
INNER_M = HALF_M - WALL_RADIUS_M  # inner face of the walls
_CORNERS = ((-HALF_M, -HALF_M), (HALF_M, -HALF_M), (HALF_M, HALF_M), (-HALF_M, HALF_M))


def room(*boxes: dict[str, Any], start: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> World:
    """A square room of 4 m with these boxes; the robot starts at its centre."""
    return world_from_document(room_document(*boxes, start=start))


def room_document(
    *boxes: dict[str, Any], start: tuple[float, float, float] = (0.0, 0.0, 0.0)
) -> dict[str, Any]:
    """The world document of `room`."""
    x_m, y_m, heading_deg = start
    corners = [list(corner) for corner in _CORNERS]
    ends = [*corners[1:], corners[0]]
    return {
        "pinel_world": 1,
        "name": "room",
        "title": {"pt-BR": "Sala", "en": "Room", "es": "Sala"},
        "size_m": [2 * HALF_M, 2 * HALF_M],
        "start": {"x_m": x_m, "y_m": y_m, "heading_deg": heading_deg},
        "walls": [{"from": a, "to": b} for a, b in zip(corners, ends, strict=True)],
        "boxes": list(boxes),
    }


def box(
    x_m: float, y_m: float, size: tuple[float, float] = (0.4, 0.4), **more: Any
) -> dict[str, Any]:
    """A box of a world document; with `movable=True, mass_kg=2` it can be pushed."""
    return {"center": [x_m, y_m], "size": list(size), "heading_deg": 0, **more}


def boxes_now(world: World, simulator: Simulator) -> list[Box]:
    """All boxes at their current poses."""
    poses = simulator.boxes()
    return [
        _moved(box, *poses[index]) if index in poses else box
        for index, box in enumerate(world.boxes)
    ]


def robot_depth_m(world: World, simulator: Simulator, robot: RobotModel = PIONEER_3DX) -> float:
    """Penetration of the robot into walls and boxes, in m; negative without contact."""
    x, y, *_ = simulator.state()
    depths = [max(abs(x), abs(y)) + robot.radius_m - INNER_M]
    depths += [robot.radius_m - _distance(box, x, y) for box in boxes_now(world, simulator)]
    return max(depths)


def boxes_depth_m(boxes: Iterable[Box]) -> float:
    """Penetration of the boxes' corners into the walls, in m; negative without contact."""
    farthest = (abs(c) for box in boxes for corner in box.corners() for c in corner)
    return max(farthest, default=0.0) - INNER_M


def _moved(box: Box, x: float, y: float, yaw: float) -> Box:
    return Box((x, y), box.size, yaw)


def _distance(box: Box, x: float, y: float) -> float:
    """Distance from a point to the box's edge, in m; negative inside."""
    dx, dy = x - box.center[0], y - box.center[1]
    cos, sin = math.cos(box.angle_rad), math.sin(box.angle_rad)
    beside = abs(cos * dx + sin * dy) - box.size[0] / 2
    above = abs(cos * dy - sin * dx) - box.size[1] / 2
    outside = math.hypot(max(beside, 0.0), max(above, 0.0))
    return outside + min(max(beside, above), 0.0)
