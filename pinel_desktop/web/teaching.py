"""The teacher's session of a request: its cookie, and the check for requests that only the teacher may make."""

import secrets

from flask import Response, after_this_request, request

from pinel_desktop.errors import PinelError
from pinel_desktop.web.services import services

_SESSION_LETTERS = 32


def require_teacher() -> None:
    """Raises PinelError `pin_missing` before a PIN is set, else `teacher_only` outside a teacher's session."""
    sessions = services().teacher
    if not sessions.has_pin:
        raise PinelError("pin_missing")
    if not is_teacher():
        raise PinelError("teacher_only")


def require_teacher_if_there_is_one() -> None:
    """Raises PinelError `teacher_only` outside a teacher's session; a PC without a PIN has no teacher yet."""
    if services().teacher.has_pin and not is_teacher():
        raise PinelError("teacher_only")


def is_teacher() -> bool:
    """True if the request belongs to a teacher's session."""
    return services().teacher.is_signed_in(request.cookies.get(_cookie()))


def set_session_cookie(answer: Response, token: str) -> Response:
    """Adds the session's cookie, which the browser deletes when its window closes."""
    answer.set_cookie(_cookie(), token, httponly=True, samesite="Strict", path="/api")
    return answer


def end_session(answer: Response) -> Response:
    """Ends the session and deletes its cookie."""
    services().teacher.sign_out(request.cookies.get(_cookie()))
    answer.delete_cookie(_cookie(), path="/api")
    return answer


def browser_session() -> str:
    """Returns the id of this browser session, from a cookie that the browser deletes when its window closes.

    The response sets the cookie if the request has none. A new session gives no additional attempts to guess the PIN.
    """
    name = f"{services().guard.cookie_name}_browser"
    known = request.cookies.get(name, "")
    if len(known) == _SESSION_LETTERS:
        return known
    made = secrets.token_hex(_SESSION_LETTERS // 2)

    @after_this_request
    def _set_cookie(answer: Response) -> Response:
        answer.set_cookie(name, made, httponly=True, samesite="Strict", path="/api")
        return answer

    return made


def _cookie() -> str:
    return f"{services().guard.cookie_name}_teacher"
