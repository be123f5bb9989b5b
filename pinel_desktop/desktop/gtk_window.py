"""What the window needs of GTK and WebKit besides pywebview. All of it runs on the window's thread."""

import contextlib
import logging
import signal
import threading
import time
from collections.abc import Callable
from typing import Any

import webview

from pinel_desktop.desktop import saving
from pinel_desktop.desktop.backends import NoWindowError, has_graphics_device
from pinel_desktop.desktop.kiosk.lock import lock_window
from pinel_desktop.desktop.kiosk.mode import KioskMode
from pinel_desktop.desktop.policy import NavigationDecision, ReloadLimit
from pinel_desktop.errors import PinelError

_PROGRAM = "pinel-desktop"
_UNAUTHORIZED = 401
_log = logging.getLogger(__name__)


def require_screen() -> None:
    """Raises NoWindowError `window_no_screen`; GTK itself would end the process without a working screen."""
    import gi  # noqa: PLC0415 - optional, see backends.gtk_problem

    gi.require_version("Gtk", "3.0")
    from gi.repository import GLib, Gtk  # noqa: PLC0415

    GLib.set_prgname(_PROGRAM)  # by which the desktop identifies the window's program
    if not Gtk.init_check([])[0]:
        raise NoWindowError("window_no_screen")


class GtkWindow:
    """The GTK parts of pywebview's window; create it before the page loads."""

    def __init__(self, window: webview.Window) -> None:
        from webview.platforms.gtk import BrowserView  # noqa: PLC0415 - see above

        self._window = window
        self._view = BrowserView.instances[window.uid]
        self._page = self._view.webview
        settings = self._page.get_settings().props
        # private mode disables local storage, which the page needs; nothing is written to disk
        settings.enable_html5_local_storage = True
        if not has_graphics_device():
            from gi.repository import WebKit2  # noqa: PLC0415 - see above

            # OpenGL on the processor would take 100 MB and twice the time for the same pictures
            settings.hardware_acceleration_policy = WebKit2.HardwareAccelerationPolicy.NEVER

    def load(self, address: str) -> None:
        """Loads an address of the page."""
        self._page.load_uri(address)

    def fill_screen(self, monitor: int) -> None:
        """Fills a screen, by its number in the desktop."""
        window = self._view.window
        window.fullscreen_on_monitor(window.get_screen(), monitor)

    def guard_navigation(self, judge: Callable[[str], NavigationDecision]) -> None:
        """Replaces pywebview's policy, which opens foreign links in the default browser."""
        from gi.repository import WebKit2  # noqa: PLC0415

        def decide(_page: Any, decision: Any, kind: Any) -> bool:
            if kind == WebKit2.PolicyDecisionType.RESPONSE:
                verdict = "show" if decision.is_mime_type_supported() else "refuse"
            else:
                address = decision.get_navigation_action().get_request().get_uri()
                is_here = kind == WebKit2.PolicyDecisionType.NAVIGATION_ACTION
                verdict = judge(address) if is_here else "refuse"
            {"show": decision.use, "save": decision.download, "refuse": decision.ignore}[verdict]()
            return True

        self._page.disconnect_by_func(self._view.on_navigation)
        self._page.connect("decide-policy", decide)

    def close_at_signals(self, close: Callable[[], None]) -> None:
        """Calls `close` at SIGTERM and SIGINT, also while a dialog is open."""
        from gi.repository import GLib, Gtk  # noqa: PLC0415

        def close_with_dialogs() -> bool:
            # an open dialog runs a main loop of its own, in which the window would wait
            for dialog in Gtk.Window.list_toplevels():
                if isinstance(dialog, Gtk.Dialog):
                    dialog.response(Gtk.ResponseType.CANCEL)
            close()
            return True

        for number in (signal.SIGTERM, signal.SIGINT):
            GLib.unix_signal_add(GLib.PRIORITY_DEFAULT, number, close_with_dialogs)

    def save_by_dialog(self) -> None:
        """Shows a save dialog for each file that the page saves."""
        context = self._page.get_context()
        saving.install_save_dialog(context, self._view.window, lambda: self._window.localization)

    def lock(self, kiosk: KioskMode) -> None:
        """Locks the window in kiosk mode, and tells the places of the page."""
        self._page.connect("notify::uri", lambda *_: kiosk.on_place(self._place()))
        lock_window(self._view, kiosk.print_permission)

    def reload_after_crash(self, address: Callable[[], str]) -> None:
        """Loads the page again, at its place, after a crash of one of WebKit's processes.

        Without the page's process, its last picture would stay for ever. The network process holds the cookies:
        without them, the app refuses every request of the page. The page gets a new address, because each address
        opens it once.
        """
        limit = ReloadLimit()

        def reload(*_: Any) -> None:
            wait_s = limit.next_wait_s(time.monotonic())
            if wait_s is not None:
                # the app may take a moment to answer, and this thread draws the window
                timer = threading.Timer(wait_s, self._load, (address, self._place()))
                timer.daemon = True
                timer.start()

        def check(resource: Any, _property: Any) -> None:
            response = resource.get_response()
            if response is not None and response.get_status_code() == _UNAUTHORIZED:
                reload()

        def watch(_page: Any, resource: Any, _request: Any) -> None:
            resource.connect("notify::response", check)

        self._page.connect("web-process-terminated", reload)
        self._page.connect("resource-load-started", watch)

    def _load(self, address: Callable[[], str], place: str) -> None:
        from gi.repository import GLib  # noqa: PLC0415

        _log.warning("the page is loaded again after a crash")
        # if the app has died, too, its end closes the window
        with contextlib.suppress(PinelError):
            GLib.idle_add(self._page.load_uri, f"{address()}#{place}")

    def _place(self) -> str:
        """The page's place, the part of its address after "#"."""
        return str(self._page.get_uri() or "").partition("#")[2]
