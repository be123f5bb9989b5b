"""The teacher's door, and what this PC is called."""

from flask import Response

from pinel_desktop.web.api import TEACHER, WRITES, answers, resource
from pinel_desktop.web.models.classes import Computer, ComputerName, Door, Pin
from pinel_desktop.web.responses import answer
from pinel_desktop.web.services import services
from pinel_desktop.web.teaching import is_teacher, let_in, require_teacher, show_out

api = resource("teacher", "The teacher's door.", __name__)


@api.get("/teacher", responses=answers(Door))
def get_door() -> Response:
    """Whether there is a PIN, and whether the door is open."""
    return answer(Door(has_pin=services().teacher.has_pin, is_open=is_teacher()))


@api.put("/teacher/pin", responses=answers(Door, *TEACHER, *WRITES))
def choose_pin(body: Pin) -> Response:
    """Chooses the PIN and opens the door. The first one is anybody's to choose, another one is for the teacher."""
    door = services().teacher
    if door.has_pin:
        require_teacher()
    door.choose(body.pin)
    return let_in(answer(Door(has_pin=True, is_open=True)), door.enter(body.pin))


@api.post(
    "/teacher/enter", responses=answers(Door, "pin_missing", "pin_wrong", "pin_wait", *WRITES)
)
def enter(body: Pin) -> Response:
    """Opens the door; wrong PINs make the next try wait."""
    token = services().teacher.enter(body.pin)
    return let_in(answer(Door(has_pin=True, is_open=True)), token)


@api.post("/teacher/leave", responses=answers(Door))
def leave() -> Response:
    """Shuts the door."""
    return show_out(answer(Door(has_pin=services().teacher.has_pin, is_open=False)))


@api.get("/computer", responses=answers(Computer, *WRITES))
def get_computer() -> Response:
    """What this PC is called."""
    key, name = services().store.computers.this()
    return answer(Computer(id=key, name=name))


@api.patch("/computer", responses=answers(Computer, *TEACHER, *WRITES))
def rename_computer(body: ComputerName) -> Response:
    """Gives this PC a name that people know it by. For the teacher."""
    require_teacher()
    computers = services().store.computers
    computers.rename(body.name)
    key, name = computers.this()
    return answer(Computer(id=key, name=name))
