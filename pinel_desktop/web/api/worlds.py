"""Worlds of runs, and robot models of the simulator."""

from typing import Any

from flask import Response

from pinel_desktop.robot import ROBOTS
from pinel_desktop.web.api import Resource, answers
from pinel_desktop.web.errors import InvalidWorldError
from pinel_desktop.web.models.robots import Robot, RobotList
from pinel_desktop.web.models.worlds import CheckedWorld, World, WorldList, WorldToCheck
from pinel_desktop.web.responses import answer, describe_faults
from pinel_desktop.web.services import services

api = Resource("worlds", "Worlds of runs, and robot models of the simulator.", __name__)


@api.get("/worlds", responses=answers(WorldList))
def list_worlds() -> Response:
    """All world documents."""
    return answer(WorldList(worlds=[_model(world) for world in services().worlds]))


@api.post("/worlds/check", responses=answers(CheckedWorld, "body_too_large"))
def check_world(body: WorldToCheck) -> Response:
    """All faults of a world, with messages."""
    parts = services()
    _, faults = parts.read_world(body.world)
    return answer(CheckedWorld(faults=describe_faults(faults, parts.settings.language)))


def sound_world(document: dict[str, Any]) -> dict[str, Any]:
    """The world document in its normal form. Raises InvalidWorldError with its faults."""
    parts = services()
    sound, faults = parts.read_world(document)
    if sound is None:
        raise InvalidWorldError(describe_faults(faults, parts.settings.language))
    return sound


def _model(document: dict[str, Any]) -> World:
    return World.model_validate(document)


@api.get("/robots", responses=answers(RobotList))
def list_robots() -> Response:
    """All robot models, the default first."""
    return answer(RobotList(robots=[Robot.of(robot) for robot in ROBOTS.values()]))
