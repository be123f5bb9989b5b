"""Programs of a group, their versions, and checking a document."""

from flask import Response
from pydantic import ValidationError

from pinel_desktop.events.app_events import ProgramChanged
from pinel_desktop.program.faults import Fault
from pinel_desktop.web.api import WRITES, Resource, responses
from pinel_desktop.web.api.worlds import valid_world
from pinel_desktop.web.models import Empty, IdPath, Json
from pinel_desktop.web.models.work import (
    CheckedDocument,
    DocumentToCheck,
    NewVersion,
    Program,
    ProgramList,
    ProgramName,
    ProgramWithVersion,
    SavedVersion,
    Setup,
    Version,
    VersionLabel,
    VersionLine,
    VersionPage,
    VersionSummary,
    WhichVersion,
)
from pinel_desktop.web.models.worlds import World
from pinel_desktop.web.presets import prepare_program
from pinel_desktop.web.responses import MAX_FAULTS, describe_faults, json_response, json_safe
from pinel_desktop.web.services import Services, read_document, services
from storage import FaultRow, ProgramRow, VersionRow
from storage import VersionSummary as VersionSummaryRow

api = Resource("programs", "Programs, their versions, and checking documents.", __name__)


@api.get("/groups/<id>/programs", responses=responses(ProgramList, "group_not_found"))
def list_programs(path: IdPath) -> Response:
    """Programs of a group, newest first."""
    return _programs(services().store.programs.of_group(path.id))


def _version_summary(row: VersionSummaryRow) -> VersionSummary:
    return VersionSummary.of(row, setup=_readable_setup(row.setup))


def _programs(rows: list[ProgramRow]) -> Response:
    return json_response(ProgramList(programs=[Program.of(row) for row in rows]))


@api.post("/groups/<id>/programs", responses=responses(Program, "group_not_found", *WRITES))
def create_program(path: IdPath, body: ProgramName) -> Response:
    """Creates an empty program, in the world of the class's preset."""
    parts = services()
    row = parts.store.programs.create(path.id, body.name)
    prepare_program(row, parts.store.groups.get(path.id), parts)
    return json_response(Program.of(parts.store.programs.get(row.id)))


@api.get(
    "/programs/<id>",
    responses=responses(ProgramWithVersion, "program_not_found", "version_damaged"),
)
def get_program(path: IdPath, query: WhichVersion) -> Response:
    """A program with its newest version, or with the newest intact version.

    The error `version_damaged` has in `params` the id and the time of the last version that can be opened.
    """
    store = services().store
    row = store.programs.get(path.id)
    versions = store.versions
    newest = versions.newest_intact(path.id) if query.sound else versions.newest(path.id)
    other_version = store.versions.newest_on_other_pc(newest) if newest else None
    return json_response(
        ProgramWithVersion.of(
            row,
            version=version_model(newest) if newest else None,
            elsewhere=_version_summary(other_version) if other_version else None,
        )
    )


@api.patch("/programs/<id>", responses=responses(Program, "program_not_found", *WRITES))
def rename_program(path: IdPath, body: ProgramName) -> Response:
    """Renames a program."""
    row = services().store.programs.rename(path.id, body.name)
    return json_response(Program.of(row))


@api.post(
    "/programs/<id>/versions",
    responses=responses(
        SavedVersion, "program_not_found", "body_too_large", "invalid_world", *WRITES
    ),
)
def save_version(path: IdPath, body: NewVersion) -> Response:
    """Saves the editor's content as a new version, which is on disk when the response is sent.

    The server reads the document and stores null if it has faults. A world with faults is refused. Content equal to the
    newest version is not stored again; the response is then that version.
    """
    parts = services()
    document, faults = None, []
    if body.document is not None:
        reading = read_document(body.document)
        document = None if reading.faults else reading.document
        faults = [_fault_row(fault) for fault in reading.faults[:MAX_FAULTS]]
    world = None if body.world is None else _world_to_save(path.id, body.world, parts)
    row = parts.store.versions.save(
        path.id,
        body.workspace,
        document,
        faults,
        world,
        setup=body.setup.as_stored() if body.setup else None,
        parent_id=body.parent_id,
    )
    program = parts.store.programs.get(path.id)
    before = parts.store.versions.history_of(path.id, before=row.id, limit=1)
    _notify_windows(program, row.id)
    return json_response(
        SavedVersion(
            id=row.id,
            created_at=row.created_at,
            faults=version_model(row).faults,
            before=before[0].id if before else None,
            deleted_at=program.deleted_at,
        )
    )


def _notify_windows(program: ProgramRow, version: str | None = None) -> None:
    services().hub.publish(ProgramChanged(program.id, version, program.deleted_at).to_wire())


def _world_to_save(program_id: str, world: Json, parts: Services) -> Json:
    """Returns the world in its normal form.

    A world saved before is accepted unchanged, even if newer rules would refuse it.
    """
    newest = parts.store.versions.newest_intact(program_id)
    return world if newest is not None and world == newest.world else valid_world(world)


@api.get("/programs/<id>/versions", responses=responses(VersionLine, "program_not_found"))
def list_versions(path: IdPath, query: VersionPage) -> Response:
    """The versions of a program, newest first, a page at a time."""
    store = services().store
    rows = store.versions.history_of(
        store.programs.get(path.id).id, before=query.before, limit=query.limit
    )
    summaries = [_version_summary(row) for row in rows]
    after = summaries[-1].id if len(summaries) == query.limit else None
    return json_response(VersionLine(versions=summaries, next=after))


@api.put("/versions/<id>/label", responses=responses(Empty, "version_not_found", *WRITES))
def label_version(path: IdPath, body: VersionLabel) -> Response:
    """Labels a version."""
    services().store.versions.label(path.id, body.text)
    return json_response(Empty())


@api.get("/groups/<id>/bin", responses=responses(ProgramList, "group_not_found"))
def list_bin(path: IdPath) -> Response:
    """Programs of a group in the bin, newest first."""
    return _programs(services().store.programs.of_group(path.id, in_bin=True))


@api.delete("/programs/<id>", responses=responses(Program, "program_not_found", *WRITES))
def delete_program(path: IdPath) -> Response:
    """Moves a program to the bin; its versions and runs stay."""
    row = services().store.programs.move_to_bin(path.id)
    _notify_windows(row)
    return json_response(Program.of(row))


@api.post("/programs/<id>/take-back", responses=responses(Program, "program_not_found", *WRITES))
def restore_program(path: IdPath) -> Response:
    """Restores a program from the bin."""
    row = services().store.programs.restore_from_bin(path.id)
    _notify_windows(row)
    return json_response(Program.of(row))


@api.post("/check", responses=responses(CheckedDocument, "body_too_large"))
def check_document(body: DocumentToCheck) -> Response:
    """All faults of a document, with messages."""
    parts = services()
    faults = read_document(body.document).faults
    return json_response(CheckedDocument(faults=describe_faults(faults, parts.settings.language)))


def version_model(row: VersionRow) -> Version:
    """Returns the response for a stored version, with messages for its faults."""
    language = services().settings.language
    return Version(
        id=row.id,
        created_at=row.created_at,
        workspace=row.workspace,
        document=row.document,
        faults=describe_faults(row.faults, language),
        world=None if row.world is None else _readable_world(row.world),
        setup=_readable_setup(row.setup),
    )


def _readable_setup(stored: Json | None) -> Setup | None:
    """Returns the version's settings for runs; None if invalid, as in a file of a newer release."""
    try:
        return None if stored is None else Setup.model_validate(stored)
    except ValidationError:
        return None


def _readable_world(document: Json) -> World | None:
    """Returns the version's world; None if invalid, so that the blocks of a program from a file can still be opened."""
    try:
        return World.model_validate(document)
    except ValidationError:
        return None


def _fault_row(fault: Fault) -> FaultRow:
    return FaultRow(
        code=fault.code, pointer=fault.pointer, block=fault.block, params=json_safe(fault.params)
    )
