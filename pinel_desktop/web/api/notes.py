"""The teacher's notes about runs."""

from flask import Response

from pinel_desktop.web.api import TEACHER, WRITES, Resource, responses
from pinel_desktop.web.models import IdPath
from pinel_desktop.web.models.classes import Note, NoteList, NotePage, NoteText
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import services
from pinel_desktop.web.teaching import require_teacher
from storage import NoteRow

api = Resource("notes", "Notes of the teacher about runs.", __name__)


@api.get("/groups/<id>/notes", responses=responses(NoteList, "group_not_found"))
def list_notes(path: IdPath, query: NotePage) -> Response:
    """Notes about runs of a group, newest first."""
    store = services().store
    return _list(store.notes.of_group(store.groups.get(path.id).id, unseen=query.unseen))


@api.get("/runs/<id>/notes", responses=responses(NoteList, "run_not_found"))
def list_notes_of_run(path: IdPath) -> Response:
    """Notes about a run, oldest first."""
    store = services().store
    return _list(store.notes.of_run(store.runs.get(path.id).id))


@api.post("/runs/<id>/notes", responses=responses(Note, *TEACHER, "run_not_found", *WRITES))
def write_note(path: IdPath, body: NoteText) -> Response:
    """Writes a note; the group reads it on its next visit. For the teacher."""
    require_teacher()
    return json_response(_note(services().store.notes.write(path.id, body.text)))


@api.patch("/notes/<id>", responses=responses(Note, *TEACHER, "note_not_found", *WRITES))
def rewrite_note(path: IdPath, body: NoteText) -> Response:
    """Changes a note and marks it as unread. For the teacher."""
    require_teacher()
    return json_response(_note(services().store.notes.rewrite(path.id, body.text)))


@api.post("/notes/<id>/seen", responses=responses(Note, "note_not_found", *WRITES))
def mark_note_read(path: IdPath) -> Response:
    """Marks a note as read by the group."""
    return json_response(_note(services().store.notes.acknowledge(path.id)))


def _list(rows: list[NoteRow]) -> Response:
    return json_response(NoteList(notes=[_note(row) for row in rows]))


def _note(row: NoteRow) -> Note:
    return Note.of(row)
