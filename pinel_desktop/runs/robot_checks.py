"""What a program asks of a robot that only the simulator can tell: known before the run, so said before it."""

from collections.abc import Iterator
from typing import Any

from pinel_desktop.program.faults import Fault
from pinel_desktop.program.pointers import Path, block_at, pointer
from pinel_desktop.program.sensors import SENSORS

_NEEDS_PLACES = "go_to_place"


def missing_on_real_robots(document: Any) -> list[Fault]:
    """A fault at each block of a sound document that reads what no real robot senses, or drives to a place by name.

    Codes: `sensor_missing`, `places_missing`.
    """
    return [
        Fault(code, pointer(path), block_at(document, path), params)
        for code, path, params in _found(document, ())
    ]


def _found(value: Any, path: Path) -> Iterator[tuple[str, Path, dict[str, object]]]:
    if isinstance(value, dict):
        sensor = SENSORS.get(str(value.get("sensor")))
        if sensor is not None and sensor.simulated_only:
            yield "sensor_missing", path, {"sensor": sensor.name}
        if value.get("action") == _NEEDS_PLACES:
            yield "places_missing", path, {}
        children = list(value.items())
    else:
        children = list(enumerate(value)) if isinstance(value, list) else []
    for key, child in children:
        yield from _found(child, (*path, key))
