"""Worlds of runs, and robot models of the simulator."""

from typing import Any

from flask import Response

from pinel_desktop.robot import ROBOTS
from pinel_desktop.web.api import Resource, responses
from pinel_desktop.web.errors import InvalidWorldError
from pinel_desktop.web.models.robots import Robot, RobotList
from pinel_desktop.web.models.worlds import CheckedWorld, World, WorldList, WorldToCheck
from pinel_desktop.web.responses import describe_faults, json_response
from pinel_desktop.web.services import read_world, services

api = Resource("worlds", "Worlds of runs, and robot models of the simulator.", __name__)


@api.get("/worlds", responses=responses(WorldList))
def list_worlds() -> Response:
    """All world documents."""
    return json_response(WorldList(worlds=[_model(world) for world in services().worlds]))


@api.post("/worlds/check", responses=responses(CheckedWorld, "body_too_large"))
def check_world(body: WorldToCheck) -> Response:
    """All faults of a world, with messages."""
    parts = services()
    _, faults = read_world(body.world)
    return json_response(CheckedWorld(faults=describe_faults(faults, parts.settings.language)))


def valid_world(document: dict[str, Any]) -> dict[str, Any]:
    """Returns the world document in its normal form. Raises InvalidWorldError with its faults."""
    parts = services()
    sound, faults = read_world(document)
    if sound is None:
        raise InvalidWorldError(describe_faults(faults, parts.settings.language))
    return sound


def _model(document: dict[str, Any]) -> World:
    return World.model_validate(document)


@api.get("/robots", responses=responses(RobotList))
def list_robots() -> Response:
    """All robot models, the default first."""
    return json_response(RobotList(robots=[Robot.of(robot) for robot in ROBOTS.values()]))
