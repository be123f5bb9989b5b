"""Worlds a run can take place in."""

from typing import Any

from flask import Response

from pinel_desktop.web.answers import answer
from pinel_desktop.web.api import answers, resource
from pinel_desktop.web.models.worlds import World, WorldList
from pinel_desktop.web.services import services

api = resource("worlds", "Worlds a run can take place in.", __name__)


@api.get("/worlds", responses=answers(WorldList))
def list_worlds() -> Response:
    """All worlds with their walls and boxes."""
    return answer(WorldList(worlds=[_model(world) for world in services().worlds]))


def _model(document: dict[str, Any]) -> World:
    return World.model_validate(document)
