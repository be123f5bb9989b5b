"""The teacher's door, and what this PC is called."""

from flask import Response

from pinel_desktop.web.answers import answer
from pinel_desktop.web.api import answers, resource
from pinel_desktop.web.models.classes import Computer, ComputerName, Door, Pin
from pinel_desktop.web.services import services
from pinel_desktop.web.teaching import is_teacher, let_in, require_teacher, show_out

api = resource("teacher", "The teacher's door.", __name__)


@api.get("/teacher", responses=answers(Door))
def get_door() -> Response:
    """Whether there is a PIN, and whether the door is open."""
    return answer(Door(has_pin=services().teacher.has_pin, is_open=is_teacher()))


@api.put("/teacher/pin", responses=answers(Door, 403, 503, 507))
def choose_pin(body: Pin) -> Response:
    """Chooses the first PIN, or another one when the door is open; it is open afterwards."""
    door = services().teacher
    if door.has_pin:
        require_teacher()
    door.choose(body.pin)
    return let_in(answer(Door(has_pin=True, is_open=True)), door.enter(body.pin))


@api.post("/teacher/enter", responses=answers(Door, 403, 429, 503, 507))
def enter(body: Pin) -> Response:
    """Opens the door; wrong PINs make the next try wait."""
    token = services().teacher.enter(body.pin)
    return let_in(answer(Door(has_pin=True, is_open=True)), token)


@api.post("/teacher/leave", responses=answers(Door))
def leave() -> Response:
    """Shuts the door."""
    return show_out(answer(Door(has_pin=services().teacher.has_pin, is_open=False)))


@api.get("/computer", responses=answers(Computer, 503, 507))
def get_computer() -> Response:
    """What this PC is called."""
    key, name = services().store.computers.here()
    return answer(Computer(id=key, name=name))


@api.patch("/computer", responses=answers(Computer, 403, 503, 507))
def rename_computer(body: ComputerName) -> Response:
    """Gives this PC a name that people know it by. For the teacher."""
    require_teacher()
    computers = services().store.computers
    computers.rename(body.name)
    key, name = computers.here()
    return answer(Computer(id=key, name=name))
