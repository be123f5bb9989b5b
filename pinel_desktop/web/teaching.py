"""The teacher's session on a request: its cookie, and the check for requests that only the teacher may make."""

from flask import Response, request

from pinel_desktop.errors import PinelError
from pinel_desktop.web.services import services


def require_teacher() -> None:
    """Raises PinelError `pin_missing` before a PIN is set, else `teacher_only` outside of a teacher's session."""
    sessions = services().teacher
    if not sessions.has_pin:
        raise PinelError("pin_missing")
    if not is_teacher():
        raise PinelError("teacher_only")


def require_teacher_if_there_is_one() -> None:
    """Raises PinelError `teacher_only` outside of a teacher's session; a PC without a PIN has no teacher yet."""
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


def _cookie() -> str:
    return f"{services().guard.cookie_name}_teacher"
