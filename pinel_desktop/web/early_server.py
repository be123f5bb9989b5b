"""Serves the page while the rest of the app is still being imported.

Meanwhile the browser loads and evaluates the page's code, which takes about as long as the imports.
"""

import threading
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from flask import Flask, Response
from werkzeug.wrappers import Request

from pinel_desktop.errors import PinelError
from pinel_desktop.messages import language_of_system
from pinel_desktop.settings import Settings
from pinel_desktop.web.guard import Guard
from pinel_desktop.web.page import PagePath, message_page, page
from pinel_desktop.web.protection import add_headers, check_guard
from pinel_desktop.web.server import Server, Wsgi

_START_TIMEOUT_S = 60.0


class EarlyServer:
    """Server and guard of one app; serves the page at once, the API after `open`.

    Args:
        settings: settings of this PC; None stores them in memory only.
        is_kiosk: whether the window is in kiosk mode.

    Raises:
        PinelError: `port_taken`.
    """

    def __init__(
        self, port: int = 0, settings: Settings | None = None, *, is_kiosk: bool = False
    ) -> None:
        self.guard = Guard()
        self.settings = settings or Settings()
        self._server = Server(port)
        self.guard.bind(self._server.host, self._server.port)
        self._page = _page_alone(_PageServices(self.guard, self.settings, is_kiosk))
        self._app: Wsgi | None = None
        self._decided = threading.Event()
        self._server.start(self, self.guard.is_known)

    def open(self, app: Wsgi) -> None:
        """Passes all requests to `app` from now on."""
        self._app = app
        self._decided.set()

    def abandon(self) -> None:
        """Answers waiting requests with status 503, because the app cannot start."""
        self._decided.set()

    def close(self) -> None:
        """Stops the server. Close the hub first, which ends the streams."""
        self.abandon()
        self._server.close()

    def __call__(self, environ: dict[str, Any], start_response: Any) -> Iterable[bytes]:
        if self._app is None and self._is_for_page(Request(environ)):
            return self._page(environ, start_response)
        if self._app is None:
            self._decided.wait(_START_TIMEOUT_S)
        answer = self._app or Response(status=503)
        return answer(environ, start_response)

    def _is_for_page(self, asked: Request) -> bool:
        """True for an authorised request for a file of the page.

        All other requests, also refused ones, wait for the app.
        """
        if asked.method != "GET" or asked.path.partition("/api")[0] == "":
            return False
        try:
            self.guard.check_origin(asked.headers)
            if asked.path != "/" or "key" not in asked.args:
                self.guard.check_cookie(asked.cookies)
        except PinelError:
            return False
        return True


@dataclass(frozen=True, slots=True)
class _PageServices:
    """The part of `Services` that serving the page needs."""

    guard: Guard
    settings: Settings
    is_kiosk: bool


def _page_alone(page_services: _PageServices) -> Flask:
    app = Flask(__name__, static_folder=None)
    app.extensions["pinel"] = page_services
    app.url_map.converters["page_path"] = PagePath
    app.register_blueprint(page)
    app.before_request(check_guard)
    app.after_request(add_headers)
    app.register_error_handler(PinelError, _refused)
    return app


def _refused(error: PinelError) -> Response:
    return message_page(error.code, error.params, language_of_system(), 401)
