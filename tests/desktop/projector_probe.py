"""Opens the real window, presents a page in a second one, and prints the results as JSON.

A separate process, for the reason given in window_probe.py.
"""

import json
import sys
import time
from collections.abc import Callable
from typing import Any

import webview
from webview.platforms import gtk

from pinel_desktop.desktop.ending import end_process
from pinel_desktop.desktop.kiosk.mode import KioskMode
from pinel_desktop.desktop.window import NativeWindow
from tests.desktop.window_probe import Site

WIDTH, HEIGHT = 1024, 768
_WITHIN_S = 30


def add_screen() -> None:
    """Adds a screen to those that pywebview lists, because Xvfb has one output, so GDK sees one monitor.

    It is the first one, so its number is that of the real monitor, which the second window then fills.
    """
    list_real: Callable[[], list[webview.Screen]] = gtk.get_screens

    def get_screens() -> list[webview.Screen]:
        real = list_real()
        beside = webview.Screen(2 * WIDTH, 0, WIDTH, HEIGHT, real[0].frame)
        return [beside, *real]

    gtk.get_screens = get_screens


def is_fullscreen(window: webview.Window) -> bool:
    from gi.repository import Gdk  # noqa: PLC0415 - see pinel_desktop/desktop/backends.py

    shown = gtk.BrowserView.instances[window.uid].window.get_window()
    return bool(shown.get_state() & Gdk.WindowState.FULLSCREEN)


class Probe:
    """The experiments, in order."""

    def __init__(self, kiosk: KioskMode | None) -> None:
        self.site = Site()
        self.window = NativeWindow(
            lambda: self.site.address,
            "PINEL Desktop",
            lambda: "pt-BR",
            on_open=self._try_everything,
            kiosk=kiosk,
        )
        self.found: dict[str, Any] = {}

    def _try_everything(self) -> None:
        try:
            self.found["presented"] = self.window.present(f"{self.site.address}#first")
            if self.found["presented"]:
                self._try_second_window()
        except Exception as error:
            self.found["error"] = repr(error)
        self.window.close()

    def _try_second_window(self) -> None:
        second = self._second("first")
        until(lambda: is_fullscreen(second))
        until(lambda: second.run_js("innerWidth") == WIDTH)
        self.found["size"] = [second.run_js("innerWidth"), second.run_js("innerHeight")]
        stranger = Site()
        second.run_js(f"location.href = '{stranger.address}'")
        second.run_js(f"window.open('{stranger.address}')")
        self.window.present(f"{self.site.address}#second")
        self._second("second")
        self.found["stranger_asked"] = len(stranger.asked)
        self.found["n_windows"] = len(webview.windows)
        self.window.present(None)
        until(lambda: len(webview.windows) == 1)
        self.found["ended"] = True
        # the main window closes it too
        self.window.present(f"{self.site.address}#third")
        self._second("third")

    def _second(self, place: str) -> webview.Window:
        """Waits for the second window to show a place of the page."""
        until(lambda: len(webview.windows) == 2)
        window = webview.windows[1]
        until(lambda: window.run_js("document.documentElement.dataset.ready") == "true")
        until(lambda: window.run_js("location.hash") == f"#{place}")
        return window

    def run(self) -> None:
        self.window.run("gtk")
        print(json.dumps(self.found), flush=True)


def until(reached: Any) -> None:
    deadline = time.monotonic() + _WITHIN_S
    while not reached():
        if time.monotonic() > deadline:
            raise TimeoutError
        time.sleep(0.05)


if __name__ == "__main__":
    if "--one-screen" not in sys.argv:
        add_screen()
    Probe(KioskMode("command", "", lambda place: None) if "--kiosk" in sys.argv else None).run()
    end_process(0)
