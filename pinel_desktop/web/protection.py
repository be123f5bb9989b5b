"""What every request must show, and what every answer carries."""

from flask import Response, request

from pinel_desktop.errors import PinelError
from pinel_desktop.web.services import services

_SECURITY_POLICY = "; ".join(
    (
        "default-src 'self'",
        "style-src 'self' 'unsafe-inline'",  # Blockly writes its style sheet into the page
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
_FOR_OTHER_STARTS = "/api/instance/"


def check_guard() -> None:
    """Refuses what did not come from our own page, or from a second start of the app."""
    guard = services().guard
    guard.check_origin(request.headers)
    if request.path.startswith(_FOR_OTHER_STARTS):
        guard.check_secret(request.headers)
        return
    try:
        guard.check_cookie(request.cookies)
    except PinelError:
        if request.path != "/" or not guard.redeem(request.args.get("key", "")):
            raise


def add_headers(answer: Response) -> Response:
    """Keeps the page to itself, and answers of the API out of every cache."""
    answer.headers.update(_HEADERS)
    if request.path.startswith("/api"):
        answer.headers["Cache-Control"] = "no-store"
    return answer
