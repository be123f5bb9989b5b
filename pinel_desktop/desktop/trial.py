"""Trial of the window for `pinel doctor`, because a toolkit that loads may still show nothing.

The window opens briefly on a small page. It has a process of its own, because a fault of the toolkit may crash or hang
the process.
"""

import json
import subprocess
import tempfile
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from socketserver import TCPServer
from typing import IO

from pinel_desktop.desktop.backends import NoWindowError, Toolkit
from pinel_desktop.desktop.presenter import TITLE
from pinel_desktop.messages import language_of_system
from pinel_desktop.processes import own_command

TIMEOUT_S = 30.0
# time for the start and the end of the process
_SPARE_S = 15.0
# the page runs a script, which asks for this address
_SHOWN = "/shown.js"
_PAGE = f"<!doctype html><title>{TITLE}</title><p>{TITLE}</p><script src='{_SHOWN}'></script>"


def window_problem(toolkit: Toolkit, timeout_s: float = TIMEOUT_S) -> NoWindowError | None:
    """Opens the window in another process; returns why it shows no page, or None if it does."""
    # files, not pipes: the toolkit's helper processes may outlive the process and leave a pipe open
    with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
        try:
            done = subprocess.run(
                own_command("window", toolkit, str(timeout_s)),
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=errors,
                timeout=timeout_s + _SPARE_S,
                check=False,
            )
        except subprocess.TimeoutExpired:
            return NoWindowError("doctor_window_silent", backend=toolkit, seconds=timeout_s)
        last_line = _text_of(errors).rpartition("\n")[2] or f"status {done.returncode}"
        return _problem_in(_text_of(output), toolkit, last_line) if done.returncode else None


def _problem_in(answer: str, toolkit: Toolkit, last_line: str) -> NoWindowError:
    """Returns the problem that the process printed, or its last line of output if the toolkit ended it."""
    try:
        problem = json.loads(answer)
    except ValueError:
        return NoWindowError("doctor_window_failed", backend=toolkit, reason=last_line)
    if problem["code"] == "window_failed":
        reason = problem["params"]["reason"] or last_line
        return NoWindowError("doctor_window_failed", backend=toolkit, reason=reason)
    return NoWindowError(problem["code"], **problem["params"])


def _text_of(file: IO[bytes]) -> str:
    file.seek(0)
    return file.read().decode(errors="replace").strip()


def show_page(toolkit: Toolkit, timeout_s: float) -> None:
    """Opens the window on a small page and closes it as soon as the page runs. Raises NoWindowError."""
    # pywebview and GTK are not installed on every PC
    from pinel_desktop.desktop.window import NativeWindow  # noqa: PLC0415

    shown = threading.Event()
    with _server(shown) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        address = f"http://127.0.0.1:{server.server_port}/"

        def close() -> None:
            shown.wait(timeout_s)
            window.close()

        window = NativeWindow(lambda: address, TITLE, language_of_system, on_open=close)
        try:
            window.run(toolkit)
        finally:
            server.shutdown()
    if not shown.is_set():
        raise NoWindowError("doctor_window_silent", backend=toolkit, seconds=timeout_s)


class _LoopbackServer(ThreadingHTTPServer):
    """Does not look for the name of its address, for which its base class may ask a name server of the network."""

    def server_bind(self) -> None:
        TCPServer.server_bind(self)
        self.server_name, self.server_port = "127.0.0.1", self.socket.getsockname()[1]


def _server(shown: threading.Event) -> ThreadingHTTPServer:
    """Returns a server for the page on the loopback address; a request for the page's script sets `shown`."""

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            is_script = self.path == _SHOWN
            body = b"" if is_script else _PAGE.encode()
            self.send_response(200)
            self.send_header("Content-Type", "text/javascript" if is_script else "text/html")
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)
            if is_script:
                shown.set()

        def log_message(self, *_args: object) -> None:
            """Logs nothing, because standard error is for the toolkit's faults."""

    return _LoopbackServer(("127.0.0.1", 0), Handler)
