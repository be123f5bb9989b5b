"""Opens a small page in kiosk mode, tries to escape by keys and by clicks on its buttons, and prints what happened.

A separate process, because GTK is bound to a main thread and one screen for the life of a process. Needs xdotool and a
screen with a window manager.
"""

import json
import subprocess
import threading
import time
from typing import Any

from flask import Flask, Response
from werkzeug.serving import make_server

from pinel_desktop.desktop.ending import end_process
from pinel_desktop.desktop.kiosk.mode import KioskMode
from pinel_desktop.desktop.window import NativeWindow

TITLE = "PINEL Desktop"
# keys of window managers, of GTK and of WebKit
KEYS = (
    "alt+F4",
    "alt+Tab",
    "alt+shift+Tab",
    "alt+Escape",
    "alt+space",
    "alt+F2",
    "alt+F9",
    "alt+F10",
    "super",
    "super+d",
    "super+e",
    "super+Tab",
    "ctrl+alt+Left",
    "ctrl+alt+d",
    "ctrl+alt+t",
    "ctrl+Escape",
    "ctrl+w",
    "ctrl+q",
    "ctrl+n",
    "ctrl+t",
    "ctrl+o",
    "ctrl+s",
    "ctrl+u",
    "ctrl+p",
    "ctrl+l",
    "ctrl+h",
    "ctrl+j",
    "ctrl+r",
    "ctrl+shift+i",
    "ctrl+shift+n",
    "ctrl+shift+c",
    "ctrl+period",
    "ctrl+semicolon",
    "ctrl+plus",
    "F1",
    "F5",
    "F10",
    "F11",
    "F12",
    "Menu",
    "shift+F10",
    "alt+Left",
    "alt+Home",
    "Escape",
    "Print",
)
# what a page can ask of the window, each by a click on a button of this name
ACTIONS = {
    "print": "window.print()",
    "file": "document.querySelector('[type=file]').click()",
    "folder": "document.querySelector('[webkitdirectory]').click()",
    "colour": "document.querySelector('[type=color]').click()",
    "blank": "location.href = 'about:blank'",
    "file address": "location.href = 'file:///etc/hostname'",
    "stranger": "location.href = 'http://127.0.0.1:9/'",
    "mail": "location.href = 'mailto:ana@example.org'",
    "new window": "window.open('/')",
    "new tab": "document.querySelector('a').click()",
    "download": (
        "Object.assign(document.createElement('a'), {download: 'a.txt', "
        "href: URL.createObjectURL(new Blob(['a']))}).click()"
    ),
    "full screen": "document.documentElement.requestFullscreen()",
    "microphone": "navigator.mediaDevices?.getUserMedia({audio: true}).catch(() => {})",
    "place": "navigator.geolocation?.getCurrentPosition(() => {})",
    "notification": "window.Notification?.requestPermission()",
    "alone": "window.close()",
}
_PAGE = (
    "<!doctype html><title>page</title><body style='margin:0'>"
    "<input type=file hidden><input type=file webkitdirectory hidden><input type=color hidden>"
    "<a href='/' target=_blank></a>"
    + "".join(
        f'<button onclick="{act}" style="display:block;width:100%;height:32px">{name}</button>'
        for name, act in ACTIONS.items()
    )
)
_PAUSE_S = 0.7
_SETTLE_S = 5.0
_HEIGHT_PX = 32


class Probe:
    """The attempts, in order."""

    def __init__(self) -> None:
        app = Flask(__name__)
        app.add_url_rule("/", view_func=lambda: Response(_PAGE, mimetype="text/html"))
        server = make_server("127.0.0.1", 0, app, threaded=True)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        self.places: list[str] = []
        self.mode = KioskMode("setting", "/here", self.places.append)
        self.address = f"http://127.0.0.1:{server.port}/"
        self.window = NativeWindow(
            lambda: self.address,
            TITLE,
            lambda: "pt-BR",
            on_open=self._try_everything,
            kiosk=self.mode,
        )
        self.found: dict[str, Any] = {"escaped": [], "tried": 0}

    def _try_everything(self) -> None:
        try:
            self._wait_until_drawn()
            self.found["geometry"] = self._xdotool("getwindowgeometry", "--shell", self._active())
            self.found["windows"] = before = self._windows()
            for key in KEYS:
                self._xdotool("key", key)
                self._judge(key, before)
            for number, name in enumerate(ACTIONS):
                self._xdotool("mousemove", "300", str(number * _HEIGHT_PX + _HEIGHT_PX // 2))
                self._xdotool("click", "1")
                self._judge(name, before)
            self.found["printed"] = self._print_as_teacher(before)
            self.found["places"] = self.places
        except Exception as error:
            self.found["error"] = repr(error)
        self.window.close()

    def _wait_until_drawn(self) -> None:
        deadline_s = time.monotonic() + 60
        while not self.window.run_script("!!document.querySelector('button')"):
            if time.monotonic() > deadline_s:
                raise TimeoutError("the page")
            time.sleep(0.1)
        time.sleep(2 * _PAUSE_S)

    def _judge(self, attempt: str, before: list[str]) -> None:
        """Records an attempt that has opened a window, closed or hidden PINEL's, or left the page."""
        time.sleep(_PAUSE_S)
        self.found["tried"] += 1
        # on a busy PC the window may be active again a moment later
        deadline_s = time.monotonic() + _SETTLE_S
        while not (is_locked := self._is_locked(before)) and time.monotonic() < deadline_s:
            time.sleep(0.1)
        if not is_locked:
            self.found["escaped"].append([attempt, self._windows(), self._active_title()])
            self._xdotool("key", "Escape")
            time.sleep(_PAUSE_S)

    def _is_locked(self, before: list[str]) -> bool:
        return self._windows() == before and self._active_title() == TITLE and self._is_page()

    def _active_title(self) -> str:
        return self._xdotool("getactivewindow", "getwindowname").strip()

    def _is_page(self) -> bool:
        address = str(self.window.run_script("location.href"))
        return address.startswith(self.address)

    def _print_as_teacher(self, before: list[str]) -> bool:
        """Whether the print dialog opens once it is allowed; it is closed again."""
        self.mode.print_permission.grant()
        self._xdotool("mousemove", "300", str(_HEIGHT_PX // 2))
        self._xdotool("click", "1")
        time.sleep(2 * _PAUSE_S)
        has_dialog = len(self._windows()) > len(before)
        self._xdotool("key", "Escape")
        return has_dialog

    def _windows(self) -> list[str]:
        return sorted(self._xdotool("search", "--onlyvisible", "--class", ".").split())

    def _active(self) -> str:
        return self._xdotool("getactivewindow").strip()

    def _xdotool(self, *arguments: str) -> str:
        done = subprocess.run(
            ["xdotool", *arguments], capture_output=True, text=True, timeout=60, check=False
        )
        return done.stdout

    def run(self) -> None:
        self.window.run("gtk")
        print(json.dumps(self.found), flush=True)


if __name__ == "__main__":
    Probe().run()
    end_process(0)
