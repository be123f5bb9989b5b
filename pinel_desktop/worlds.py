"""Reads and checks world documents that groups made; returns their faults with message codes."""

from collections.abc import Sequence
from typing import Any

from pinel_desktop.program.duplicates import duplicate_key_faults
from pinel_desktop.program.faults import Fault
from pinel_desktop.robot import ROBOTS, SimulationConfig
from sim.document import MAX_BYTES
from sim.parsing import read_world

__all__ = ["MAX_BYTES", "read_own_world"]

_MAX_RADIUS_M = max(robot.radius_m for robot in ROBOTS.values())


def read_own_world(
    source: Any, *, robot: str | None = None
) -> tuple[dict[str, Any] | None, Sequence[Fault]]:
    """Returns a world document in its normal form, or None and its faults.

    Args:
        source: JSON text, or parsed data.
        robot: the robot model that must fit at the start pose; by default the largest, so that every model fits.

    Raises:
        PinelError: `unknown_robot`.
    """
    radius_m = SimulationConfig(robot).robot.radius_m if robot else _MAX_RADIUS_M
    reading = read_world(source, robot_radius_m=radius_m)
    faults = [Fault(fault.code, fault.pointer, None, fault.params) for fault in reading.faults]
    if isinstance(source, str | bytes) and len(source) <= MAX_BYTES:
        faults = [*duplicate_key_faults(source), *faults]
    return (None if faults else reading.document), faults
