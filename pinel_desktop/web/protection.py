"""Applies the guard to every request, and adds security headers to every response."""

from flask import Response, request

from pinel_desktop.errors import PinelError
from pinel_desktop.web.guard import Guard
from pinel_desktop.web.services import services

_SECURITY_POLICY = "; ".join(
    (
        "default-src 'self'",
        # of messages that are pages, and Blockly writes one into the text of a block's warning
        "style-src-attr 'unsafe-inline'",
        "img-src 'self' data:",
        "object-src 'none'",
        "base-uri 'none'",
        "form-action 'none'",
        "frame-ancestors 'none'",
    )
)
_HEADERS = {
    "Content-Security-Policy": _SECURITY_POLICY,
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "Cross-Origin-Resource-Policy": "same-origin",
}
_INSTANCE_ROUTES = "/api/instance/"


def check_guard() -> None:
    """Refuses requests that come neither from our page nor from a second start of the app. Raises PinelError."""
    guard = services().guard
    is_opened = _uses_key(guard)
    guard.check_origin(request.headers)
    if request.path.startswith(_INSTANCE_ROUTES):
        guard.check_secret(request.headers)
        return
    try:
        guard.check_cookie(request.cookies)
    except PinelError:
        if request.path != "/" or not is_opened:
            raise


def _uses_key(guard: Guard) -> bool:
    """Uses up the key in the address, even if the request is refused later; HEAD requests use up no key."""
    return request.method != "HEAD" and guard.redeem(request.args.get("key", ""))


def add_headers(answer: Response) -> Response:
    """Adds security headers, and disables caching of the API's responses."""
    answer.headers.update(_HEADERS)
    if request.path.startswith("/api"):
        answer.headers["Cache-Control"] = "no-store"
    return answer
