"""Requests of a second start of the app to the first one, authorised by the secret of the instance file."""

from flask import Response
from pydantic import BaseModel, ConfigDict, Field

from pinel_desktop.web.api import Resource, responses
from pinel_desktop.web.models import Empty
from pinel_desktop.web.models.exchange import FileToOpen
from pinel_desktop.web.models.status import InstanceLink
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import services

api = Resource("instance", "For a second start of the app on the same data.", __name__)


class Secret(BaseModel):
    """The header used instead of the cookie; the guard checks it before the handler runs."""

    model_config = ConfigDict(populate_by_name=True)

    secret: str = Field(alias="X-Pinel-Secret")


@api.post("/instance/link", responses=responses(InstanceLink))
def create_instance_link(header: Secret) -> Response:
    """A new address that opens the page once."""
    return json_response(InstanceLink(url=services().guard.fresh_link()))


@api.post("/instance/show", responses=responses(Empty))
def show_instance(header: Secret) -> Response:
    """Brings the window forward."""
    return _show()


@api.post("/instance/open", responses=responses(Empty))
def open_file(header: Secret, body: FileToOpen) -> Response:
    """Leads all pages to where the teacher merges a file of this PC, and brings the window forward."""
    services().opened_file.choose(body.path)
    return _show()


def _show() -> Response:
    window = services().window
    if window is not None:
        window.ask("show")
    return json_response(Empty())
