"""Starts the app with delays: each request of the page takes 200 to 600 ms longer, independently of other requests.

A part of the delay precedes the processing of a request, the rest lies between processing and response. A stream starts
late. Requests of the tests themselves are not delayed, because only browsers send `Sec-Fetch-Site`.
"""

import os
import random
import threading
import time
from collections.abc import Callable, Iterable
from typing import Any

from pinel_desktop.__main__ import main
from pinel_desktop.web import early_server
from pinel_desktop.web.server import Server, Wsgi
from tests.e2e.delays import SEED

_MIN_S, _MAX_S = 0.2, 0.6


class LateAnswers:
    """Wraps the app and delays each request on its own thread."""

    def __init__(self, app: Wsgi, seed: str, sleep: Callable[[float], None] = time.sleep) -> None:
        self._app, self._sleep = app, sleep
        self._random, self._lock = random.Random(seed), threading.Lock()

    def __call__(self, environ: dict[str, Any], start_response: Any) -> Iterable[bytes]:
        before_s, after_s = self._delays() if "HTTP_SEC_FETCH_SITE" in environ else (0.0, 0.0)
        self._sleep(before_s)
        answer: Iterable[bytes] = self._app(environ, start_response)
        self._sleep(after_s)
        return answer

    def _delays(self) -> tuple[float, float]:
        with self._lock:
            whole_s, part = self._random.uniform(_MIN_S, _MAX_S), self._random.random()
        return whole_s * part, whole_s * (1 - part)


class _LateServer(Server):
    def start(self, app: Wsgi, *arguments: Any, **options: Any) -> None:
        super().start(LateAnswers(app, os.environ[SEED]), *arguments, **options)


if __name__ == "__main__":
    early_server.Server = _LateServer  # type: ignore[attr-defined]
    main()
