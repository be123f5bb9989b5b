"""Permanent deletion of groups, classes and notes, from the database and its backups."""

from flask import Response

from pinel_desktop.web.api import TEACHER, WRITES, Resource, responses
from pinel_desktop.web.models import IdPath
from pinel_desktop.web.models.exchange import Removed, WrittenFile
from pinel_desktop.web.responses import json_response, json_safe
from pinel_desktop.web.services import services
from pinel_desktop.web.teaching import require_teacher

api = Resource("removal", "Permanent deletion.", __name__)


@api.delete(
    "/groups/<id>",
    responses=responses(Removed, *TEACHER, "group_not_found", "run_in_progress", *WRITES),
)
def delete_group(path: IdPath) -> Response:
    """Deletes a group with all its work, also from the backups; merging cannot restore it. For the teacher."""
    return _delete("group", path.id)


@api.delete(
    "/classrooms/<id>",
    responses=responses(Removed, *TEACHER, "classroom_not_found", "run_in_progress", *WRITES),
)
def delete_classroom(path: IdPath) -> Response:
    """Deletes a class with its groups and lessons, as for a group. For the teacher."""
    return _delete("classroom", path.id)


@api.delete("/notes/<id>", responses=responses(Removed, *TEACHER, "note_not_found", *WRITES))
def delete_note(path: IdPath) -> Response:
    """Deletes a note, as for a group. For the teacher."""
    return _delete("note", path.id)


def _delete(kind: str, key: str) -> Response:
    require_teacher()
    removal = services().store.exchange.purge(kind, key)
    services().signs.refresh()  # removes the children's hands from the camera's classifier too
    return json_response(
        Removed(
            n_groups=removal.counts.get("groups", 0),
            n_programs=removal.counts.get("programs", 0),
            n_runs=removal.counts.get("runs", 0),
            backups=[json_safe(str(path)) for path in removal.still_in],
            files=[
                WrittenFile(path=json_safe(one.path), made_at=one.made_at)
                for one in removal.exports
            ],
        )
    )
