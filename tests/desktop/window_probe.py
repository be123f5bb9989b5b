"""Opens the real window on a small page, tries to navigate away, and prints the results as JSON.

A separate process, because GTK is bound to a main thread and one screen for the life of a process.
"""

import json
import sys
import tempfile
import threading
import time
from pathlib import Path
from typing import Any

from flask import Flask, Response
from werkzeug.serving import make_server

from pinel_desktop.desktop import saving
from pinel_desktop.desktop.ending import end_process
from pinel_desktop.desktop.window import NativeWindow

_PAGE = "<!doctype html><title>page</title><h1>PINEL</h1><script src='/ready.js'></script>"
_READY = """
document.documentElement.dataset.ready = "true";
localStorage.setItem("kept", "yes");
"""
_POLICY = "default-src 'self'; form-action 'none'; frame-ancestors 'none'"
_SAVE = """
const link = document.createElement("a");
link.href = URL.createObjectURL(new Blob(["a world"], { type: "application/json" }));
link.download = "world.json";
link.click();
"""
_OWN_BLOB = "location.href = URL.createObjectURL(new Blob(['<h1>no</h1>'], { type: 'text/html' }))"


class Site:
    """A server on its own port that records requests."""

    def __init__(self) -> None:
        self.asked: list[str] = []
        app = Flask(__name__)
        app.add_url_rule("/", view_func=self._page)
        app.add_url_rule(
            "/ready.js", view_func=lambda: Response(_READY, mimetype="text/javascript")
        )
        self._server = make_server("127.0.0.1", 0, app, threaded=True)
        self.address = f"http://127.0.0.1:{self._server.port}/"
        threading.Thread(target=self._server.serve_forever, daemon=True).start()

    def _page(self) -> Response:
        self.asked.append("/")
        return Response(_PAGE, mimetype="text/html", headers={"Content-Security-Policy": _POLICY})


class Probe:
    """The experiments, in order."""

    def __init__(self) -> None:
        self.own, self.stranger = Site(), Site()
        self.window = NativeWindow(
            lambda: self.own.address, "PINEL Desktop", lambda: "pt-BR", on_open=self._try_everything
        )
        self.found: dict[str, Any] = {}
        self.closed_at = 0.0

    def _script(self, script: str) -> Any:
        return self.window.run_script(script)

    def _until(self, script: str) -> None:
        """Polls the page; each poll runs its event loop once."""
        deadline = time.monotonic() + 30
        while self._script(script) is not True:
            if time.monotonic() > deadline:
                raise TimeoutError(script)

    def _leave(self, script: str) -> None:
        """Runs a script in the page, then its event loop a few times."""
        self._script(f"window.turns = 0; {script}")
        self._until("(setTimeout(() => { window.turns += 1 }), window.turns > 5)")

    def _try_everything(self) -> None:
        try:
            self._until("document.documentElement.dataset.ready === 'true'")
            self.found["ready"] = True
            self.found["storage"] = self._script("localStorage.getItem('kept')")
            self.found["size"] = [self._script("innerWidth"), self._script("innerHeight")]
            there = self.stranger.address
            self._leave(f"location.href = '{there}'")
            self._leave(f"window.open('{there}')")
            self._leave(
                "{const link = Object.assign(document.createElement('a'),"
                f"{{href: '{there}', target: '_blank'}}); document.body.append(link); link.click()}}"
            )
            self._leave("location.href = 'data:text/html,hello'")
            self._leave("location.href = 'file:///etc/hostname'")
            self.found["saved"] = self._save_file()
            self._leave(_OWN_BLOB)
            self.found["stranger_asked"] = len(self.stranger.asked)
            self.found["address"] = self._script("location.href")
            self.window.show()
            self._script("delete document.documentElement.dataset.ready; location.reload()")
            self._until("document.documentElement.dataset.ready === 'true'")
            self.found["reloaded"] = len(self.own.asked) == 2
        except Exception as error:
            self.found["error"] = repr(error)
        if "--wait" in sys.argv:
            print("open", flush=True)
            return
        self.closed_at = time.monotonic()
        self.window.close()

    def _save_file(self) -> str:
        """Saves a file from the page as ui/src/shell/save_file.ts does; the dialog is answered at once."""
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "kept.json"
            saving.ask_for_path = lambda *_: str(file)
            self._script(_SAVE)
            deadline = time.monotonic() + 30
            while not (file.is_file() and file.read_text("utf-8")) and time.monotonic() < deadline:
                self._script("1")
            return file.read_text("utf-8") if file.is_file() else ""

    def run(self) -> None:
        self.window.run("gtk")
        if "--wait" not in sys.argv:
            self.found["closing_s"] = round(time.monotonic() - self.closed_at, 3)
        print(json.dumps(self.found | {"own": self.own.address}), flush=True)


if __name__ == "__main__":
    Probe().run()
    end_process(0)
