"""Shows the page with the best available backend: native window, browser in app mode, or just its address."""

import logging
import threading
import webbrowser
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Protocol

import pinel_desktop
from pinel_desktop.desktop.backends import Backend, NoWindowError, Pc, Toolkit, backends
from pinel_desktop.desktop.browser import BrowserWindow
from pinel_desktop.desktop.kiosk.mode import KioskMode
from pinel_desktop.messages import describe

TITLE = "PINEL Desktop"
# part of the page, which a fresh clone has not built yet
_ICON = Path(pinel_desktop.__file__).parent / "web" / "static" / "icon.png"
# JavaScript: true once the workspace shows a block and the page has the Run button
USABLE = (
    "!!document.querySelector('.blocklyDraggable') && !!document.querySelector('[data-testid=run]')"
)
# not worth a message: Qt is optional
_UNREPORTED_PROBLEMS = ("window_qt_missing",)
_log = logging.getLogger(__name__)


class OpenWindow(Protocol):
    """An open window."""

    def show(self) -> None:
        """Brings it forward."""

    def close(self) -> None:
        """Closes it."""

    def present(self, address: str | None) -> bool:
        """Shows an address on a second screen, as `WindowLink.present` in web/services.py."""


class Presenter:
    """Shows the page until the person closes it. `show` and `close` may be called from any thread.

    Args:
        fresh_address: gives an address that works once, for each backend tried; may block until the app answers.
        language: the language of messages; may block likewise. `run` raises what these two raise.
        print_text: prints a line for people.
        give: prints the address, if no window can be shown.
        on_open: called when a native window has opened.
        kiosk: shows the page in kiosk mode, which only a native window has.
    """

    def __init__(
        self,
        fresh_address: Callable[[], str],
        language: Callable[[], str],
        *,
        print_text: Callable[[str], None],
        give: Callable[[str], None],
        pc: Pc | None = None,
        on_open: Callable[[], None] | None = None,
        kiosk: KioskMode | None = None,
    ) -> None:
        self._fresh_address = fresh_address
        self._print_text = print_text
        self._give = give
        self._language = language
        self._pc = pc or Pc()
        self._on_open = on_open
        self._kiosk = kiosk
        self._window: OpenWindow | None = None
        self._closed = threading.Event()
        self.backend: str = "none"

    def run(self) -> None:
        """Shows the page; returns when it was closed, or after `close`.

        Raises NoWindowError `kiosk_no_window` if kiosk mode has no native window.
        """
        if not self._pc.has_screen:
            self._print_message("window_no_screen", {})
        for backend in backends(self._pc):
            if self._kiosk is not None and backend.name == "browser":
                continue
            if self._closed.is_set() or self._try(backend):
                return
        if self._kiosk is not None:
            raise NoWindowError("kiosk_no_window")
        self._give_address()

    def show(self) -> None:
        """Brings the window forward, if there is one."""
        window = self._window  # another thread may end it meanwhile
        if window is not None:
            window.show()

    def close(self) -> None:
        """Makes `run` return."""
        self._closed.set()
        window = self._window
        if window is not None:
            window.close()

    def present(self, address: str | None) -> bool:
        """Shows an address on a second screen; None ends that. Returns whether a second screen shows it."""
        window = self._window
        return window is not None and window.present(address)

    def _try(self, backend: Backend) -> bool:
        """Shows the page with a backend; True if it was shown and closed, False if the backend cannot show it."""
        try:
            if backend.problem:
                raise NoWindowError(backend.problem, **backend.params)
            self.backend = backend.name
            _log.info("the page is shown by %s", backend.name)
            if backend.name == "browser":
                self._show_in_browser()
            else:
                self._show_in_window(backend.name)
        except NoWindowError as error:
            _log.info("%s does not show the page: %s", backend.name, error)
            if error.code not in _UNREPORTED_PROBLEMS:
                self._print_message(error.code, error.params)
            return False
        finally:
            self._window = None
        return True

    def _show_in_window(self, toolkit: Toolkit) -> None:
        # pywebview and GTK take half a second to import, and are not installed on every PC
        from pinel_desktop.desktop.window import NativeWindow  # noqa: PLC0415

        window = NativeWindow(
            self._fresh_address,
            TITLE,
            self._language,
            icon=str(_ICON) if _ICON.is_file() else None,
            on_open=self._on_open,
            kiosk=self._kiosk,
        )
        self._use(window)
        window.run(toolkit)

    def _show_in_browser(self) -> None:
        window = BrowserWindow(self._fresh_address, self._pc)
        self._use(window)
        window.run()

    def _use(self, window: OpenWindow) -> None:
        """Makes it the window that `close` closes, also if `close` was called a moment ago."""
        self._window = window
        if self._closed.is_set():
            window.close()

    def _give_address(self) -> None:
        """Prints the address for the person to open, as the last fallback; returns only after `close`."""
        self.backend = "address"
        _log.info("the page is shown by %s", self.backend)
        address = self._fresh_address()
        text = describe("window_address", {}, self._language())
        self._print_text(text.message)
        self._give(address)
        self._print_text(text.remedy)
        if self._pc.has_screen:
            webbrowser.open(address)
        # with a timeout, because Windows handles Ctrl+C only between waits
        while not self._closed.wait(0.5):
            pass

    def _print_message(self, code: str, params: Mapping[str, object]) -> None:
        text = describe(code, params, self._language())
        self._print_text(text.line)
