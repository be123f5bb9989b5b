"""The second window, which presents runs or a program on a second screen, such as a projector."""

from flask import Response

from pinel_desktop.web.api import Resource, responses
from pinel_desktop.web.models import Empty
from pinel_desktop.web.models.projector import Presented, ProjectorState
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import services

api = Resource("projector", "The second window, on a projector.", __name__)


@api.put("/projector", responses=responses(ProjectorState))
def present(body: Presented) -> Response:
    """Opens a window with the presentation of one or two runs or of a program, if the PC has a second screen."""
    window = services().window
    # a page of its own, which needs an address of its own: the second window has other cookies
    address = f"{services().guard.fresh_link()}#/present/second/{body.place}"
    return json_response(ProjectorState(has_window=window is not None and window.present(address)))


@api.delete("/projector", responses=responses(Empty))
def end_presentation() -> Response:
    """Closes that window, if it is open."""
    window = services().window
    if window is not None:
        window.present(None)
    return json_response(Empty())
