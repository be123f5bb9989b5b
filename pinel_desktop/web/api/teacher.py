"""The teacher's sessions, and the name of this PC."""

from flask import Response

from pinel_desktop.web.api import TEACHER, WRITES, Resource, responses
from pinel_desktop.web.models.classes import Computer, ComputerName, Pin, TeacherSession
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import services
from pinel_desktop.web.teaching import (
    browser_session,
    end_session,
    is_teacher,
    require_teacher,
    set_session_cookie,
)

api = Resource("teacher", "The teacher's session.", __name__)


@api.get("/teacher", responses=responses(TeacherSession))
def get_session() -> Response:
    """Whether a PIN is set, and whether the teacher is signed in."""
    return json_response(TeacherSession(has_pin=services().teacher.has_pin, is_open=is_teacher()))


@api.put("/teacher/pin", responses=responses(TeacherSession, *TEACHER, *WRITES))
def choose_pin(body: Pin) -> Response:
    """Sets the PIN and signs the teacher in. The first PIN is for anybody, a new one for the teacher."""
    sessions = services().teacher
    if sessions.has_pin:
        require_teacher()
    sessions.set_pin(body.pin)
    return set_session_cookie(
        json_response(TeacherSession(has_pin=True, is_open=True)),
        sessions.sign_in(body.pin, browser_session()),
    )


@api.post(
    "/teacher/enter",
    responses=responses(TeacherSession, "pin_missing", "pin_wrong", "pin_wait", *WRITES),
)
def enter(body: Pin) -> Response:
    """Signs the teacher in. After several wrong PINs the next attempt must wait."""
    token = services().teacher.sign_in(body.pin, browser_session())
    return set_session_cookie(json_response(TeacherSession(has_pin=True, is_open=True)), token)


@api.post("/teacher/leave", responses=responses(TeacherSession))
def leave() -> Response:
    """Signs the teacher out."""
    return end_session(
        json_response(TeacherSession(has_pin=services().teacher.has_pin, is_open=False))
    )


@api.get("/computer", responses=responses(Computer, *WRITES))
def get_computer() -> Response:
    """The key and name of this PC."""
    return _computer()


@api.patch("/computer", responses=responses(Computer, *TEACHER, *WRITES))
def rename_computer(body: ComputerName) -> Response:
    """Renames this PC. For the teacher."""
    require_teacher()
    services().store.computers.rename(body.name)
    return _computer()


def _computer() -> Response:
    key, name = services().store.computers.this()
    return json_response(Computer(id=key, name=name))
