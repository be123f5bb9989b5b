"""Reading sensors into the language's units: metres, degrees, seconds, in the start frame."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.execution.values import Value

if TYPE_CHECKING:
    from pinel_desktop.execution.context import RunContext


def measures(context: RunContext) -> dict[str, Callable[[], Value]]:
    """The sensors without parameters, by name; each is read when it is called."""
    sensors = context.sensors
    return {
        "x": lambda: context.pose.x_m,
        "y": lambda: context.pose.y_m,
        "heading": lambda: math.degrees(context.pose.yaw_rad),
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
    return float(min(context.sensors.sonar(index) for index in indices))


def lidar(context: RunContext, angle_deg: float) -> float:
    """What the laser scanner measures at an angle from the heading, in m."""
    return float(context.sensors.lidar(math.radians(angle_deg)))
