"""The native window, by pywebview: shows the page and blocks navigation to anything else."""

import contextlib
import logging
import os
import signal
import threading
import time
from collections.abc import Callable
from typing import Any

import webview
from webview.guilib import initialize

from pinel_desktop.desktop import saving
from pinel_desktop.desktop.backends import NoWindowError, Toolkit, renderer_problem
from pinel_desktop.desktop.policy import (
    NavigationDecision,
    ReloadLimit,
    decide_navigation,
    fitted_size,
)
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
_PROGRAM = "pinel-desktop"
_log = logging.getLogger(__name__)


class NativeWindow:
    """One window with one page, which may not leave the origin of its address.

    Call `run` on the main thread; all other methods may be called on any thread.

    Args:
        address: called before the window opens, so that the page loads meanwhile.
        language: called on a thread of its own, and may block.
        on_open: called on the same thread once the window is open.
    """

    def __init__(
        self,
        address: Callable[[], str],
        title: str,
        language: Callable[[], str],
        *,
        icon: str | None = None,
        on_open: Callable[[], None] | None = None,
    ) -> None:
        self._address = address
        self._title = title
        self._language = language
        self._icon = icon
        self._on_open = on_open
        self._window: webview.Window | None = None
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
                _require_gtk_screen()
            toolkit = initialize(backend)
            if problem := renderer_problem(toolkit.renderer):
                raise NoWindowError(problem)
            screen = toolkit.get_screens()[0]
            self._origin = self._address()
            # GTK uses our dialog (saving.py), because pywebview's fails without a download folder
            webview.settings["ALLOW_DOWNLOADS"] = backend != "gtk"
            # else a link to a new window would open the default browser
            webview.settings["OPEN_EXTERNAL_LINKS_IN_BROWSER"] = backend != "edgechromium"
            self._create(screen)
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
            self._window.on_top = False

    def close(self) -> None:
        """Closes the window, now or as soon as it is open, so that `run` returns."""
        self._closing = True
        if self._window is not None and self._opened.is_set():
            self._window.destroy()

    def run_script(self, script: str) -> Any:
        """Runs JavaScript in the page and returns its value with GTK and Qt; elsewhere it may be None."""
        return None if self._window is None else self._window.run_js(script)

    def _create(self, screen: webview.Screen) -> None:
        size = fitted_size(screen.width, screen.height)
        window = webview.create_window(
            self._title,
            self._origin,
            width=size.width,
            height=size.height,
            min_size=size.min_size,
            maximized=size.maximized,
            background_color=_BACKGROUND,
            text_select=True,
        )
        if window is None:
            raise NoWindowError("window_failed", backend="pywebview", reason="")
        window.events.before_show += self._guard
        window.events.shown += self._open
        self._window = window

    def _guard(self) -> None:
        """Installs the navigation policy; runs on the window's thread before the page loads."""
        if self._window is None:
            return
        if webview.renderer == "gtkwebkit2":
            _guard_gtk(self._window, self._decide)
            _reload_after_crash(self._window, self._address)
        elif webview.renderer == "edgechromium":
            from webview.platforms.winforms import BrowserView  # noqa: PLC0415 - only on Windows

            install_policy(BrowserView.instances[self._window.uid].browser.webview, self._decide)

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


def _require_gtk_screen() -> None:
    """Raises NoWindowError `window_no_screen`; GTK itself would end the process without a working screen."""
    import gi  # noqa: PLC0415 - optional, see backends.gtk_problem

    gi.require_version("Gtk", "3.0")
    from gi.repository import GLib, Gtk  # noqa: PLC0415

    GLib.set_prgname(_PROGRAM)  # by which the desktop identifies the window's program
    if not Gtk.init_check([])[0]:
        raise NoWindowError("window_no_screen")


def _guard_gtk(window: webview.Window, judge: Callable[[str], NavigationDecision]) -> None:
    """Sets up GTK's web view: navigation policy, local storage, save dialog, and closing at a signal."""
    from gi.repository import GLib, WebKit2  # noqa: PLC0415
    from webview.platforms.gtk import BrowserView  # noqa: PLC0415

    view = BrowserView.instances[window.uid]

    def decide(_view: Any, decision: Any, kind: Any) -> bool:
        if kind == WebKit2.PolicyDecisionType.RESPONSE:
            verdict = "show" if decision.is_mime_type_supported() else "refuse"
        else:
            address = decision.get_navigation_action().get_request().get_uri()
            is_here = kind == WebKit2.PolicyDecisionType.NAVIGATION_ACTION
            verdict = judge(address) if is_here else "refuse"
        {"show": decision.use, "save": decision.download, "refuse": decision.ignore}[verdict]()
        return True

    # pywebview's own handler opens foreign links in the default browser, saves unsupported files
    view.webview.disconnect_by_func(view.on_navigation)
    view.webview.connect("decide-policy", decide)
    saving.install_save_dialog(view.webview.get_context(), view.window, lambda: window.localization)
    # private mode disables local storage, which the page needs; nothing is written to disk
    view.webview.get_settings().props.enable_html5_local_storage = True
    for number in (signal.SIGTERM, signal.SIGINT):
        GLib.unix_signal_add(GLib.PRIORITY_DEFAULT, number, window.destroy)


def _reload_after_crash(window: webview.Window, address: Callable[[], str]) -> None:
    """Loads the page again, at its place, when GTK's page process has died; else its last picture would stay for ever.

    It gets a new address, because the app refuses WebKit's own reload: each address opens the page once.
    """
    from gi.repository import GLib  # noqa: PLC0415
    from webview.platforms.gtk import BrowserView  # noqa: PLC0415

    limit, page = ReloadLimit(), BrowserView.instances[window.uid].webview

    def load(place: str) -> None:
        with contextlib.suppress(
            PinelError
        ):  # the app has died, too, and its end closes the window
            GLib.idle_add(page.load_uri, f"{address()}#{place}")

    def reload(_page: Any, _reason: Any) -> None:
        if limit.allows(time.monotonic()):
            place = page.get_uri().partition("#")[2]
            # the app may take a moment to answer, and this thread draws the window
            threading.Thread(target=load, args=(place,), daemon=True).start()
        else:
            _log.error("the page's process dies each time")

    page.connect("web-process-terminated", reload)
