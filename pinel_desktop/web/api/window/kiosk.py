"""Kiosk mode: its state, and what the teacher may do in it."""

from flask import Response

from pinel_desktop.errors import PinelError
from pinel_desktop.settings import KIOSK
from pinel_desktop.web.api import TEACHER, Resource, responses
from pinel_desktop.web.models import Empty
from pinel_desktop.web.models.kiosk import KioskChoice, KioskState
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import WindowLink, WindowRequest, services
from pinel_desktop.web.teaching import require_teacher

api = Resource("kiosk", "Kiosk mode.", __name__)


@api.get("/kiosk", responses=responses(KioskState))
def get_kiosk() -> Response:
    """Whether the window is in kiosk mode, and whether it opens so."""
    return _state()


@api.put("/kiosk", responses=responses(KioskState, *TEACHER))
def choose_kiosk(body: KioskChoice) -> Response:
    """Chooses whether the window opens in kiosk mode; one that is in the other mode opens again. For the teacher."""
    require_teacher()
    services().settings.choose(KIOSK, "1" if body.is_chosen else "")
    answer = _state()
    window = services().window
    if window is not None and window.kiosk != "command" and _is_kiosk(window) != body.is_chosen:
        _ask_afterwards(answer, window, "restart")
    return answer


@api.post("/kiosk/leave", responses=responses(Empty, *TEACHER, "kiosk_not_active"))
def leave_kiosk() -> Response:
    """Closes the app. For the teacher."""
    answer = json_response(Empty())
    _ask_afterwards(answer, _locked_window(), "close")
    return answer


@api.post("/kiosk/print", responses=responses(Empty, *TEACHER, "kiosk_not_active"))
def allow_print() -> Response:
    """Lets the page open the print dialog, which leads to files: once, within 2 minutes. For the teacher."""
    _locked_window().ask("allow_print")
    return json_response(Empty())


def _locked_window() -> WindowLink:
    require_teacher()
    window = services().window
    if window is None or not _is_kiosk(window):
        raise PinelError("kiosk_not_active")
    return window


def _ask_afterwards(answer: Response, window: WindowLink, request: WindowRequest) -> None:
    """Sends a request that ends this process, once the answer is sent: it would be lost otherwise."""
    answer.call_on_close(lambda: window.ask(request))


def _is_kiosk(window: WindowLink) -> bool:
    return window.kiosk is not None


def _state() -> Response:
    window = services().window
    return json_response(
        KioskState(
            is_active=services().is_kiosk,
            is_chosen=services().settings.opens_kiosk,
            is_by_command=window is not None and window.kiosk == "command",
            has_window=window is not None,
        )
    )
