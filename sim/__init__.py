"""2D physics simulator: worlds, the robot's body, stepping. A leaf: imports nothing of the application."""

from sim.simulator import SUBSTEP_S, SUBSTEPS, TICK_S, Simulator
from sim.world import (
    DEFAULT_WORLD,
    World,
    WorldError,
    list_worlds,
    load_world,
    world_document,
    world_from_document,
)

__all__ = [
    "DEFAULT_WORLD",
    "SUBSTEPS",
    "SUBSTEP_S",
    "TICK_S",
    "Simulator",
    "World",
    "WorldError",
    "list_worlds",
    "load_world",
    "world_document",
    "world_from_document",
]
