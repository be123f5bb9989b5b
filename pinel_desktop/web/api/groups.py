"""Groups of pupils."""

from flask import Response

from pinel_desktop.school.album import album_of
from pinel_desktop.school.teacher_programs import teacher_group
from pinel_desktop.web.api import TEACHER, WRITES, Resource, responses
from pinel_desktop.web.models import IdPath
from pinel_desktop.web.models.album import Album, Sticker
from pinel_desktop.web.models.work import Group, GroupChanges, GroupList, NewGroup
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import services
from pinel_desktop.web.teaching import is_teacher, require_teacher
from storage import GroupRow
from storage.work.groups import Appearance

api = Resource("groups", "Groups of pupils.", __name__)


@api.get("/groups", responses=responses(GroupList))
def list_groups() -> Response:
    """All groups, most recently used first."""
    store = services().store
    own = teacher_group(store)
    return json_response(GroupList(groups=[_group(row, own) for row in store.groups.all()]))


def _group(row: GroupRow, of_teacher: str | None) -> Group:
    return Group.of(row, of_teacher=row.id == of_teacher)


@api.post("/groups", responses=responses(Group, "classroom_not_found", "group_exists", *WRITES))
def create_group(body: NewGroup) -> Response:
    """Creates a group; its name must be unique in its class, ignoring case and spaces."""
    groups = services().store.groups
    appearance = Appearance(body.color or "", body.picture, body.robot_name, body.robot_pattern)
    row = groups.create(body.name, classroom_id=body.classroom_id, appearance=appearance)
    return json_response(_group(row, teacher_group(services().store)))


@api.patch(
    "/groups/<id>",
    responses=responses(
        Group, *TEACHER, "group_not_found", "classroom_not_found", "group_exists", *WRITES
    ),
)
def change_group(path: IdPath, body: GroupChanges) -> Response:
    """Changes a group's name, colour, picture, robot or class; the class is for the teacher."""
    changes = body.model_dump(exclude_none=True)
    if "classroom_id" in changes:
        require_teacher()
    row = services().store.groups.change(path.id, changes, by_teacher=is_teacher())
    return json_response(_group(row, teacher_group(services().store)))


@api.get("/groups/<id>/album", responses=responses(Album, "group_not_found"))
def get_album(path: IdPath) -> Response:
    """The group's album: a sticker, or its empty place, for each activity, and some for character."""
    parts = services()
    if not parts.store.groups.get(path.id).has_album:
        return json_response(Album(enabled=False, stickers=[]))
    stickers = album_of(parts.store, path.id, parts.settings.language)
    return json_response(Album(enabled=True, stickers=[Sticker.of(one) for one in stickers]))
