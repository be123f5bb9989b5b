"""Worlds as the application meets them: a document that a group made is read, and its faults have words."""

from typing import Any

from pinel_desktop.program.faults import Fault
from pinel_desktop.robot import ROBOTS
from sim.reading import WorldReading, read_world
from sim.world_faults import WorldFault

# a world that is kept must have room for whichever robot its runs will choose
LARGEST_ROBOT_M = max(robot.radius_m for robot in ROBOTS.values())


def read_own_world(source: Any, *, robot_radius_m: float = LARGEST_ROBOT_M) -> WorldReading:
    """Reads a world document, as JSON text or as parsed data, whose start has room for a robot of that radius."""
    return read_world(source, robot_radius_m=robot_radius_m)


def faults_of(reading: WorldReading) -> tuple[Fault, ...]:
    """The faults as those of programs are told; no block belongs to a world."""
    return tuple(_fault(fault) for fault in reading.faults)


def _fault(fault: WorldFault) -> Fault:
    return Fault(fault.code, fault.pointer, None, fault.params)
