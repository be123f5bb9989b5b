"""What only the teacher may do: a cookie of its own says that the PIN was given."""

from flask import Response, request

from pinel_desktop.errors import PinelError
from pinel_desktop.web.services import services


def require_teacher() -> None:
    """Raises PinelError `pin_missing` where there is no PIN yet, else `teacher_only` while the door is shut."""
    door = services().teacher
    if not door.has_pin:
        raise PinelError("pin_missing")
    if not is_teacher():
        raise PinelError("teacher_only")


def is_teacher() -> bool:
    """Whether the one who asks has given the PIN, not too long ago."""
    return services().teacher.is_open(request.cookies.get(_cookie()))


def let_in(answer: Response, token: str) -> Response:
    """Hands the token to the page; gone when the window is closed."""
    answer.set_cookie(_cookie(), token, httponly=True, samesite="Strict", path="/api")
    return answer


def show_out(answer: Response) -> Response:
    """Takes the token back."""
    services().teacher.leave(request.cookies.get(_cookie()))
    answer.delete_cookie(_cookie(), path="/api")
    return answer


def _cookie() -> str:
    return f"{services().guard.cookie_name}_teacher"
