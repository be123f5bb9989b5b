"""Error handlers: convert every exception, expected or not, to the same JSON error shape."""

import logging
from typing import Any

from flask import Flask, Response, request
from pydantic import ValidationError
from werkzeug.exceptions import HTTPException, MethodNotAllowed, RequestEntityTooLarge

from pinel_desktop.errors import PinelError
from pinel_desktop.web.invalid import first_problem
from pinel_desktop.web.models.errors import Fault
from pinel_desktop.web.page import message_page
from pinel_desktop.web.responses import error_response, json_safe
from pinel_desktop.web.services import services
from storage import StoreError

_log = logging.getLogger(__name__)


class InvalidProgramError(PinelError):
    """A version with faults, which cannot run."""

    def __init__(self, faults: list[Fault]) -> None:
        super().__init__("invalid_program", count=len(faults))
        self.faults = faults


class InvalidWorldError(PinelError):
    """A world document with faults."""

    def __init__(self, faults: list[Fault]) -> None:
        super().__init__("invalid_world", count=len(faults))
        self.faults = faults


class InvalidActivityError(PinelError):
    """An invalid activity, or one that no program could pass."""

    def __init__(self, faults: list[Fault]) -> None:
        super().__init__("invalid_activity", count=len(faults))
        self.faults = faults


def install(app: Flask) -> None:
    """Registers the error handlers."""
    app.register_error_handler(PinelError, _known)
    app.register_error_handler(StoreError, _known)
    app.register_error_handler(HTTPException, _of_http)
    app.register_error_handler(Exception, _unforeseen)


def invalid_request(error: ValidationError) -> Response:
    """Returns the response to an invalid body or query, with a message about its first error."""
    message_code, params = first_problem(error)
    return _response("invalid_request", params, message_code=message_code)


def _known(error: Any) -> Response:
    return _response(error.code, error.params, faults=getattr(error, "faults", []))


def _of_http(error: HTTPException) -> Response:
    match error:
        case RequestEntityTooLarge():
            return _response(
                "body_too_large", {"max_mib": (request.max_content_length or 0) // 2**20}
            )
        case MethodNotAllowed():
            allowed = sorted(error.valid_methods or [])
            answer = _response("method_not_allowed", {"method": request.method, "allowed": allowed})
            answer.headers["Allow"] = ", ".join(allowed)
            return answer
    if error.code == 404:
        return _response("not_found", {"path": request.path})
    return _response("bad_request", {"status": error.code or 400}, status=error.code or 400)


def _unforeseen(error: Exception) -> Response:
    _log.error("%s %s failed", request.method, str(request.url_rule), exc_info=error)
    return _response("internal_error", {"detail": type(error).__name__})


def _response(
    code: str,
    params: dict[str, object],
    *,
    faults: list[Fault] | None = None,
    status: int | None = None,
    message_code: str | None = None,
) -> Response:
    language = services().settings.language
    answer = error_response(
        code, params, language, faults=faults or (), status=status, message_code=message_code
    )
    if request.path.startswith("/api"):
        return answer
    return message_page(message_code or code, json_safe(params), language, answer.status_code)
