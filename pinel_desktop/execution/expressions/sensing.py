"""Sensor readings in the language's units: metres, degrees, seconds; start frame."""

import math
from collections.abc import Callable
from typing import Any

from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.execution.expressions.requests import EvaluationContext
from pinel_desktop.execution.expressions.values import Value
from pinel_desktop.execution.places import place_under
from pinel_desktop.program.sensors import DEGREES, SENSORS, Argument
from pinel_desktop.robot import RobotModel
from pinel_desktop.robot.sensors import missing

_ROUNDING_DEG = 1e-9
_DRIVE_DIRECTIONS = ("front", "back")  # the robot cannot drive sideways
_ALONG = math.sin(math.radians(15.0))
# Clearance beside the hull. With this value an echo nearer than 0.5 m always counts, also between
# the beams along the path.
_CLEAR_M = 0.15


def reader(context: EvaluationContext, name: str) -> Callable[..., Value]:
    """The function that reads a sensor, with the value of the sensor's argument if it has one.

    The function raises PinelError `sensor_missing` if the robot lacks the sensor.
    """
    if name in _OF_THE_RUN:
        read = _OF_THE_RUN[name]
        return lambda *asked: read(context, *asked)
    sensor = SENSORS[name]
    read = context.sensors.reader(name)
    if sensor.unit == DEGREES:
        read = _in_degrees(read)
    return read if sensor.argument is None else _asked(read, sensor.argument)


def cost(context: EvaluationContext, name: str, asked: Any) -> int:
    """Weight of a sensor reading, in expression parts."""
    n_readings = len(context.robot.distance_sonars[asked]) if name == "distance" else 1
    return SENSORS[name].cost * n_readings


def _asked(read: Callable[..., Value], argument: Argument) -> Callable[..., Value]:
    """Wraps a function: converts its argument from the language's units."""
    if argument.whole:
        return lambda value: read(int(value))
    if argument.unit == DEGREES:
        return lambda value: read(math.radians(value))
    return read


def _in_degrees(read: Callable[..., Any]) -> Callable[..., Value]:
    return lambda *asked: _heading_deg(read(*asked))


def _distance(context: EvaluationContext, direction: str) -> Value:
    """Returns the smallest measurement (m) of the sonars in a direction; ahead and behind, only of the robot's path."""
    robot, measured = context.robot, context.sensors.sonar
    indices = robot.distance_sonars[direction]  # type: ignore[index]
    if not indices:
        missing("distance")
    if direction not in _DRIVE_DIRECTIONS:
        return float(min(measured(index) for index in indices))
    echoes = [(robot.sonars[index].angle_rad, measured(index)) for index in indices]
    return min(
        (found for angle, found in echoes if _is_in_path(robot, angle, found)),
        default=robot.sonar_range_m,
    )


def _is_in_path(robot: RobotModel, angle_rad: float, measured_m: float) -> bool:
    """Returns whether an echo ahead or behind counts.

    An echo of a sonar along the path always counts, because the path behind the echo is unknown. An echo of another
    sonar counts if the hull would touch the obstacle, or nearly so; otherwise it is a side wall.
    """
    aside = abs(math.sin(angle_rad))
    return aside <= _ALONG or (robot.radius_m + measured_m) * aside <= robot.radius_m + _CLEAR_M


def _mark_here(context: EvaluationContext) -> str:
    return context.marked.here(place_under(context.sensors), context.pose)


def _heading_deg(yaw_rad: float) -> float:
    """Heading in (-180, 180]; snaps values next to -180 to 180."""
    degrees = math.degrees(yaw_rad)
    return degrees if degrees > -180.0 + _ROUNDING_DEG else 180.0


# derived from the run's state or from other sensors; links have no method for them
_OF_THE_RUN: dict[str, Callable[..., Value]] = {
    "x": lambda context: context.pose.x_m,
    "y": lambda context: context.pose.y_m,
    "heading": lambda context: _heading_deg(context.pose.yaw_rad),
    "time": lambda context: (context.tick - 1) / TICK_HZ,
    "distance": _distance,
    "has_mark": lambda context: _mark_here(context) != "",
    "mark_here": _mark_here,
}
