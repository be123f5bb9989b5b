"""Generates `ui/src/blocks/table/sensor_rows.ts`: the page's data of the blocks that read sensors."""

from itertools import groupby
from typing import Any

from pinel_desktop.program.sensors import SENSORS, Argument, Sensor
from scripts.reference.typescript import typescript

_HEAD = """\
// Made by `python -m scripts.reference` from pinel_desktop/program/sensors.py. Do not edit.

/** The blocks that read sensors; those with several sensors let one of them be chosen. */
export const SENSOR_ROWS = [
"""
_GIVES = {"number": "Number", "text": "String", "boolean": "Boolean"}


def sensor_rows() -> str:
    """Returns the text of the file as TypeScript."""
    groups = groupby(SENSORS.values(), key=lambda sensor: sensor.block_type)
    rows = [_row(block, list(sensors)) for block, sensors in groups]
    return "".join([_HEAD, *(f"  {typescript(row)},\n" for row in rows), "] as const;\n"])


def _row(block: str, sensors: list[Sensor]) -> dict[str, Any]:
    first = sensors[0]
    row: dict[str, Any] = {"type": block, "level": first.level, "gives": _GIVES[first.gives]}
    row["sensors"] = [sensor.name for sensor in sensors]
    row["asked"] = None if first.argument is None else _asked(first.argument)
    return row


def _asked(argument: Argument) -> dict[str, Any]:
    if argument.choices:
        return {"key": argument.name, "choices": list(argument.choices)}
    precision = 1 if argument.whole else 0.1
    limits = {"min": argument.low, "max": argument.high, "precision": precision}
    return {"key": argument.name, "start": argument.start, "limits": limits}
