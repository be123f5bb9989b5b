"""Reading sensors into the language's units: metres, degrees, seconds, in the start frame."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.execution.values import Value
from pinel_desktop.robot.sensors import missing

if TYPE_CHECKING:
    from pinel_desktop.execution.context import RunContext


_ROUNDING_DEG = 1e-9


def measures(context: RunContext) -> dict[str, Callable[[], Value]]:
    """The sensors without parameters, by name; each is read when it is called."""
    sensors = context.sensors
    return {
        "x": lambda: context.pose.x_m,
        "y": lambda: context.pose.y_m,
        "heading": lambda: _heading_deg(context.pose.yaw_rad),
        "time": lambda: (context.tick - 1) / TICK_HZ,
        "bumper": sensors.bumper,
        "floor": sensors.floor,
        "cell": sensors.cell,
    }


def sonar(context: RunContext, index: float) -> float:
    """What a sonar measures, in m; its range when nothing is near."""
    return float(context.sensors.sonar(int(index)))


def distance(context: RunContext, direction: str) -> float:
    """How much room there is in a direction, in m: what the nearest of its sonars measures."""
    indices = context.robot.distance_sonars[direction]  # type: ignore[index]
    if not indices:
        missing("distance")
    return float(min(context.sensors.sonar(index) for index in indices))


def lidar(context: RunContext, angle_deg: float) -> float:
    """What the laser scanner measures at an angle from the heading, in m."""
    return float(context.sensors.lidar(math.radians(angle_deg)))


def _heading_deg(yaw_rad: float) -> float:
    """In (-180, 180]: straight back is 180, also where rounding has put it a hair beyond."""
    degrees = math.degrees(yaw_rad)
    return degrees if degrees > -180.0 + _ROUNDING_DEG else 180.0
