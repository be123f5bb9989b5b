"""Serves the page's static files, built from `ui/`, and error messages as HTML pages."""

import json
import re
from html import escape
from pathlib import Path

from flask import Blueprint, Response, redirect, request, send_from_directory
from werkzeug.routing import PathConverter
from werkzeug.wrappers import Response as BaseResponse

from pinel_desktop.command_name import command_name
from pinel_desktop.messages import describe
from pinel_desktop.settings import THEME
from pinel_desktop.web.services import services

STATIC = Path(__file__).parent / "static"

page = Blueprint("page", __name__)

_ROOT = re.compile(rb"(<html[^>]*)>")

# with style attributes, because the security policy refuses style elements
_MESSAGE = """<!doctype html>
<html lang="{language}"><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>PINEL</title>
<body style="font: 1.25rem/1.5 sans-serif; color: #23211d; background: #faf7f2; margin: 0;
  min-height: 100vh; display: grid; place-items: center">
<main style="max-width: 34rem; padding: 2rem">
<h1 style="font-size: 1.75rem; line-height: 1.25">{message}</h1><p>{remedy}</p></main></body></html>
"""


def message_page(code: str, params: dict[str, object], language: str, status: int) -> Response:
    """Returns an HTML page with a message and its remedy."""
    text = describe(code, params, language)
    html = _MESSAGE.format(
        language=escape(language), message=escape(text.message), remedy=escape(text.full_remedy)
    )
    return Response(html, status=status, mimetype="text/html")


@page.get("/")
def index() -> BaseResponse:
    """The page with the texts of the chosen language; `ui/vite.config.ts` builds one file for each language.

    A request with a one-time key gets the cookie and a redirect that removes the key from the address.
    """
    if "key" in request.args:
        return _signed_in(redirect("/"))
    if not (STATIC / "index.html").is_file():
        return message_page("page_not_built", {}, services().settings.language, 503)
    settings = services().settings
    return _with_settings(_file(f"index.{settings.language}.html", conditional=False))


def _with_settings(answer: BaseResponse) -> BaseResponse:
    """Inserts settings and command into the page, so that it needs no request for them and starts with its theme."""
    settings = services().settings
    more = {"data-settings": json.dumps(settings.of_page()), "data-command": command_name()}
    if settings[THEME]:
        more["data-theme"] = settings[THEME]
    if services().is_kiosk:
        more["data-kiosk"] = "1"
    attributes = "".join(f' {name}="{escape(value)}"' for name, value in more.items())
    answer.set_data(_ROOT.sub(rb"\1" + attributes.encode() + b">", answer.get_data(), count=1))
    answer.add_etag(overwrite=True)
    answer.headers.pop("Last-Modified", None)
    return answer.make_conditional(request)


class PagePath(PathConverter):
    """A path outside `/api`, where an unknown address must not be reported as a missing file."""

    regex = r"(?!api(?:/|$))[^/].*?"


@page.get("/<page_path:name>")
def asset(name: str) -> BaseResponse:
    """A file of the page. Names under `assets/` contain a hash of the content, so these files never change."""
    answer = _file(name)
    if name.startswith("assets/") and answer.status_code == 200:
        answer.headers["Cache-Control"] = "private, max-age=31536000, immutable"
    return answer


def _file(name: str, *, conditional: bool = True) -> BaseResponse:
    answer = send_from_directory(STATIC, name, conditional=conditional)
    # read at once: the server would leave the file open if the browser disconnected meanwhile
    close = getattr(answer.response, "close", lambda: None)
    answer.direct_passthrough = False
    answer.freeze()
    close()
    answer.headers["Cache-Control"] = "no-cache"
    return answer


def _signed_in(answer: BaseResponse) -> BaseResponse:
    guard = services().guard
    answer.set_cookie(
        guard.cookie_name, guard.cookie_value, httponly=True, samesite="Strict", path="/"
    )
    answer.headers["Cache-Control"] = "no-store"
    return answer
