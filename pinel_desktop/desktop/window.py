"""The native window, by pywebview: shows the page and blocks navigation to anything else."""

import logging
import os
import threading
from collections.abc import Callable
from typing import Any

import webview
from webview.guilib import initialize

from pinel_desktop.desktop.backends import NoWindowError, Toolkit, renderer_problem
from pinel_desktop.desktop.gtk_window import GtkWindow, require_screen
from pinel_desktop.desktop.kiosk.mode import KioskMode
from pinel_desktop.desktop.policy import NavigationDecision, decide_navigation, fitted_size
from pinel_desktop.desktop.projector import ProjectorWindow
from pinel_desktop.desktop.webview2 import install_policy
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe

# pywebview's keys of dialog texts, and our message codes
_DIALOG_TEXTS = {
    "global.quitConfirmation": "dialog_quit",
    "global.ok": "dialog_ok",
    "global.quit": "dialog_leave",
    "global.cancel": "dialog_cancel",
    "global.saveFile": "dialog_save_file",
    "linux.openFile": "dialog_open_file",
    "linux.openFiles": "dialog_open_files",
    "linux.openFolder": "dialog_open_folder",
    "windows.fileFilter.allFiles": "dialog_all_files",
    "windows.fileFilter.otherFiles": "dialog_other_files",
}
_BACKGROUND = "#f6f3ee"


class NativeWindow:
    """One window with one page, which may not leave the origin of its address.

    Call `run` on the main thread; all other methods may be called on any thread.

    Args:
        address: called before the window opens, so that the page loads meanwhile.
        language: called on a thread of its own, and may block.
        on_open: called on the same thread once the window is open.
        kiosk: None opens an ordinary window.
    """

    def __init__(
        self,
        address: Callable[[], str],
        title: str,
        language: Callable[[], str],
        *,
        icon: str | None = None,
        on_open: Callable[[], None] | None = None,
        kiosk: KioskMode | None = None,
    ) -> None:
        self._address = address
        self._title = title
        self._language = language
        self._icon = icon
        self._on_open = on_open
        self._kiosk = kiosk
        self._window: webview.Window | None = None
        self._projector = ProjectorWindow(title, _BACKGROUND, self._decide)
        self._origin = ""
        self._opened = threading.Event()
        self._closing = False
        self._failure: BaseException | None = None

    def run(self, backend: Toolkit) -> None:
        """Shows the window until it is closed.

        Raises:
            NoWindowError: `window_webview2_missing`, `window_no_screen` or `window_failed` if it could not be opened.
            PinelError: from `address`, or from `language` after closing the window.
        """
        if "PYWEBVIEW_LOG" not in os.environ:
            logging.getLogger("pywebview").setLevel(logging.CRITICAL)
        try:
            if backend == "gtk":
                require_screen()
            toolkit = initialize(backend)
            if problem := renderer_problem(toolkit.renderer):
                raise NoWindowError(problem)
            screen = toolkit.get_screens()[0]
            self._origin = self._address()
            place = self._kiosk.place if self._kiosk else ""
            # GTK uses our dialog (saving.py), because pywebview's fails without a download folder
            webview.settings["ALLOW_DOWNLOADS"] = backend != "gtk"
            # else a link to a new window would open the default browser
            webview.settings["OPEN_EXTERNAL_LINKS_IN_BROWSER"] = backend != "edgechromium"
            self._create(screen, f"{self._origin}#{place}" if place else self._origin)
            # Windows reads no PNG; without an icon pywebview takes the program's
            webview.start(gui=backend, icon=None if backend == "edgechromium" else self._icon)
        except PinelError:
            raise
        except Exception as error:  # pywebview passes on any exception of its toolkit
            raise NoWindowError("window_failed", backend=backend, reason=str(error)) from error
        finally:
            webview.windows.clear()
        if self._failure is not None:
            raise self._failure
        if not self._opened.is_set():
            raise NoWindowError("window_failed", backend=backend, reason="")

    def show(self) -> None:
        """Brings the window forward."""
        if self._window is not None and self._opened.is_set():
            self._window.restore()
            # Window managers may refuse a request for focus, but not a window that is set on top.
            self._window.on_top = True
            self._window.on_top = self._kiosk is not None

    def close(self) -> None:
        """Closes the window, now or as soon as it is open, so that `run` returns."""
        self._closing = True
        if self._window is not None and self._opened.is_set():
            self._window.destroy()

    def present(self, address: str | None) -> bool:
        """Shows an address on a second screen; None ends that. Returns whether a second screen shows it.

        Kiosk mode opens no second window: what locks it locks one window.
        """
        if self._window is None or not self._opened.is_set() or self._kiosk is not None:
            return False
        if address is None:
            self._projector.close()
            return False
        return self._projector.show(address, self._window)

    def run_script(self, script: str) -> Any:
        """Runs JavaScript in the page and returns its value with GTK and Qt; elsewhere it may be None."""
        return None if self._window is None else self._window.run_js(script)

    def _create(self, screen: webview.Screen, address: str) -> None:
        size = fitted_size(screen.width, screen.height)
        window = webview.create_window(
            self._title,
            address,
            width=size.width,
            height=size.height,
            min_size=size.min_size,
            maximized=size.maximized,
            fullscreen=self._kiosk is not None,
            background_color=_BACKGROUND,
            text_select=True,
        )
        if window is None:
            raise NoWindowError("window_failed", backend="pywebview", reason="")
        window.events.before_show += self._guard
        if self._kiosk is not None:
            # a handler that returns False refuses to close
            window.events.closing += lambda: self._closing
        window.events.closed += self._projector.close
        window.events.shown += self._open
        self._window = window

    def _guard(self) -> None:
        """Installs the navigation policy; runs on the window's thread before the page loads."""
        if self._window is None:
            return
        if webview.renderer == "gtkwebkit2":
            self._guard_gtk(GtkWindow(self._window))
        elif webview.renderer == "edgechromium":
            from webview.platforms.winforms import BrowserView  # noqa: PLC0415 - only on Windows

            install_policy(BrowserView.instances[self._window.uid].browser.webview, self._decide)

    def _guard_gtk(self, gtk: GtkWindow) -> None:
        gtk.guard_navigation(self._decide)
        gtk.close_at_signals(self.close)
        gtk.reload_after_crash(self._address)
        if self._kiosk is None:
            gtk.save_by_dialog()
        else:
            gtk.lock(self._kiosk)

    def _decide(self, address: str) -> NavigationDecision:
        return decide_navigation(address, self._origin)

    def _open(self) -> None:
        """Runs on a thread of its own once the window is open."""
        self._opened.set()
        try:
            if self._window is not None and not self._closing:
                self._window.localization.update(_dialog_texts(self._language()))
        except BaseException as failure:
            self._failure = failure
            self.close()
            return
        if self._closing:
            self.close()
        elif self._on_open is not None:
            self._on_open()


def _dialog_texts(language: str) -> dict[str, str]:
    return {key: describe(code, {}, language).message for key, code in _DIALOG_TEXTS.items()}
