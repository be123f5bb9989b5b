"""The WSGI application: routes, guard, error responses and headers."""

import json
from collections.abc import Callable
from typing import Any

from flask import Flask, Response, current_app, request
from flask.json.provider import DefaultJSONProvider
from werkzeug.routing import Rule

from pinel_desktop.errors import PinelError
from pinel_desktop.web import errors
from pinel_desktop.web.page import PagePath, page
from pinel_desktop.web.protection import add_headers, check_guard
from pinel_desktop.web.routes import RESOURCES
from pinel_desktop.web.services import Services

MAX_BODY = 4 * 2**20  # a document of 1 MiB and its workspace
MAX_FILE = 64 * 2**20
_UPLOAD_PATHS = (
    "/api/programs/file",
    "/api/lessons/file",
    "/api/drives/file",
    "/api/camera/recognizers",
)


def create_app(parts: Services) -> Flask:
    """Builds the WSGI application on the given services."""
    app = _Flask(__name__, static_folder=None)
    for module in RESOURCES:
        app.register_blueprint(module.api)
    app.extensions["pinel"] = parts
    app.json = _StrictJson(app)
    app.config["MAX_CONTENT_LENGTH"] = MAX_BODY
    app.add_url_rule("/api/openapi.json", view_func=_description)
    app.url_map.converters["page_path"] = PagePath
    app.register_blueprint(page)
    app.before_request(check_guard)
    app.before_request(_check_body)
    app.after_request(add_headers)
    errors.install(app)
    return app


class _Rule(Rule):
    """A rule that only matches: Werkzeug also compiles the functions of `url_for`, for half of `create_app`'s time."""

    def _compile_builder(self, append_unknown: bool = True) -> Callable[..., tuple[str, str]]:
        return _no_address


def _no_address(rule: Rule, **values: Any) -> tuple[str, str]:
    raise NotImplementedError("url_for")


class _Flask(Flask):
    url_rule_class = _Rule


class _StrictJson(DefaultJSONProvider):
    """Standard JSON only: refuses NaN, Infinity, numbers beyond doubles and excessive nesting."""

    def loads(self, s: str | bytes, **kwargs: Any) -> Any:
        try:
            return json.loads(s, parse_constant=_refuse, parse_float=_finite, **kwargs)
        except RecursionError:
            raise ValueError("nested too deep") from None


def _refuse(constant: str) -> float:
    raise ValueError(f"{constant} is not JSON")


def _finite(text: str) -> float:
    value = float(text)
    if value in (float("inf"), float("-inf")):
        raise ValueError(f"{text} is too large for a double")
    return value


def _check_body() -> None:
    """Raises PinelError `invalid_json` if the body is no JSON: its message is better than the models' message.

    Requests with a file are exempt and get a larger limit.
    """
    if request.path in _UPLOAD_PATHS and request.mimetype == "application/octet-stream":
        request.max_content_length = MAX_FILE
        return
    if not request.get_data(cache=True):
        return
    if not request.is_json:
        raise PinelError("invalid_json", problem=f"Content-Type {request.mimetype or '-'}")
    try:
        current_app.json.loads(request.get_data(cache=True))
    except ValueError as error:
        raise PinelError("invalid_json", problem=str(error)) from None


def _description() -> Response:
    from pinel_desktop.web.description import description_text  # noqa: PLC0415 - heavy, and hardly ever asked for

    return Response(description_text(), mimetype="application/json")
