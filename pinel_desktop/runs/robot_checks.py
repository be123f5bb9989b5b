"""Static checks of a program against a robot: reports missing sensors and places before the run starts."""

from collections.abc import Iterator
from typing import Any

from pinel_desktop.program.faults import Fault
from pinel_desktop.program.pointers import Path, block_at, pointer
from pinel_desktop.program.sensors import SENSORS
from pinel_desktop.robot import RobotModel

_NEEDS_PLACES = "go_to_place"
_Found = Iterator[tuple[str, Path, dict[str, object]]]


def missing_on_real_robots(document: Any) -> list[Fault]:
    """Returns faults of a valid document on real robots: simulator-only sensors, and drives to places by name.

    Codes: `sensor_missing`, `places_missing`.
    """

    def found() -> _Found:
        for path, value in _objects(document, ()):
            sensor = SENSORS.get(str(value.get("sensor")))
            if sensor is not None and sensor.simulated_only:
                yield "sensor_missing", path, {"sensor": sensor.name}
            if value.get("action") == _NEEDS_PLACES:
                yield "places_missing", path, {}

    return _faults(document, found())


def missing_on_model(document: Any, robot: RobotModel) -> list[Fault]:
    """Returns a fault for each block of a valid document that reads a sensor which the robot model lacks.

    Codes: `sensor_missing`; `angle_out_of_range` for an angle outside the field of the model's laser scanner.
    """

    def found() -> _Found:
        for path, value in _objects(document, ()):
            sensor = SENSORS.get(str(value.get("sensor")))
            if sensor is None:
                continue
            asked = value.get(sensor.argument.name) if sensor.argument else None
            asked = None if isinstance(asked, dict) else asked
            if robot.lacks(sensor.name, asked):
                yield "sensor_missing", path, {"sensor": sensor.name}
            elif sensor.name == "lidar" and robot.laser and asked is not None:
                max_deg = robot.laser.field_deg / 2
                if abs(asked) > max_deg:
                    bounds = {"value": asked, "min": -max_deg, "max": max_deg}
                    yield "angle_out_of_range", (*path, "angle"), bounds

    return _faults(document, found())


def _faults(document: Any, found: _Found) -> list[Fault]:
    return [
        Fault(code, pointer(path), block_at(document, path), params) for code, path, params in found
    ]


def _objects(value: Any, path: Path) -> Iterator[tuple[Path, dict[str, Any]]]:
    """Yields every object of a document with its path, in order."""
    if isinstance(value, dict):
        yield path, value
        children = list(value.items())
    else:
        children = list(enumerate(value)) if isinstance(value, list) else []
    for key, child in children:
        yield from _objects(child, (*path, key))
