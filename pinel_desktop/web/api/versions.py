"""Single versions, and differences of two versions."""

from flask import Response

from pinel_desktop.web.api import Resource, responses
from pinel_desktop.web.api.programs import version_model
from pinel_desktop.web.models import IdPath
from pinel_desktop.web.models.review import (
    DifferenceTo,
    VersionDifference,
    VersionOfProgram,
)
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import services

api = Resource("versions", "Single versions, and differences of two.", __name__)


@api.get(
    "/versions/<id>", responses=responses(VersionOfProgram, "version_not_found", "version_damaged")
)
def get_version(path: IdPath) -> Response:
    """A version with its number, label and parent."""
    row = services().store.versions.get(path.id)
    version = version_model(row)
    return json_response(
        VersionOfProgram.of(
            version,
            program_id=row.program_id,
            number=row.number,
            label=row.label,
            parent_id=row.parent_id,
        )
    )


@api.get(
    "/versions/<id>/difference",
    responses=responses(VersionDifference, "version_not_found", "version_damaged"),
)
def get_difference(path: IdPath, query: DifferenceTo) -> Response:
    """Differences to a later version, block by block.

    Blocks are compared by their ids; shadow blocks count as values of their parents.
    """
    # not needed at the app's start
    from pinel_desktop.school.review import difference  # noqa: PLC0415

    versions = services().store.versions
    before, after = (versions.get(version_id) for version_id in (path.id, query.to))
    found = difference(before.workspace, after.workspace)
    return json_response(VersionDifference.of(found))
