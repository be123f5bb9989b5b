"""Groups of pupils."""

from flask import Response

from pinel_desktop.web.answers import answer
from pinel_desktop.web.api import answers, resource
from pinel_desktop.web.models.work import Group, GroupList, NewGroup
from pinel_desktop.web.services import services

api = resource("groups", "Groups of pupils.", __name__)


@api.get("/groups", responses=answers(GroupList))
def list_groups() -> Response:
    """All groups, newest use first."""
    rows = services().store.groups.all()
    return answer(
        GroupList(groups=[Group.model_validate(row, from_attributes=True) for row in rows])
    )


@api.post("/groups", responses=answers(Group, 409, 503, 507))
def create_group(body: NewGroup) -> Response:
    """Makes a group; its name must be free."""
    row = services().store.groups.create(body.name)
    return answer(Group.model_validate(row, from_attributes=True))
