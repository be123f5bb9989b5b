"""Shows the page in the best way that this PC has: native window, browser in app mode, plain address."""

import threading
import webbrowser
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Protocol

import pinel_desktop
from pinel_desktop.desktop.backends import Backend, NoWindowError, Pc, Toolkit, backends
from pinel_desktop.desktop.browser import BrowserWindow
from pinel_desktop.messages import describe

TITLE = "PINEL Desktop"
# of the page, which is built after a clone
_ICON = Path(pinel_desktop.__file__).parent / "web" / "static" / "icon.png"
# The workspace has drawn its first block, and there is a button to run it.
USABLE = (
    "!!document.querySelector('.blocklyDraggable') && !!document.querySelector('[data-testid=run]')"
)
# Qt is an extra: that it is missing is no news to anybody.
_NO_NEWS = ("window_qt_missing",)


class OpenWindow(Protocol):
    """A window that is being shown."""

    def show(self) -> None:
        """Brings it forward."""

    def close(self) -> None:
        """Closes it."""


class Presenter:
    """Keeps the page on the screen until the person closes it.

    `fresh_address` gives an address that works once: every way that is tried gets its own. It and `language` may
    wait until the app can answer; what they raise, `run` raises. `say` is given the
    lines that a person should read, `give` the address that a person or a program may open. `show` and `close`
    may be called from any thread, at any time.
    """

    def __init__(
        self,
        fresh_address: Callable[[], str],
        language: Callable[[], str],
        *,
        say: Callable[[str], None],
        give: Callable[[str], None],
        pc: Pc | None = None,
        on_open: Callable[[], None] | None = None,
    ) -> None:
        self._fresh_address = fresh_address
        self._say = say
        self._give = give
        self._language = language
        self._pc = pc or Pc()
        self._on_open = on_open
        self._window: OpenWindow | None = None
        self._closed = threading.Event()
        self.backend: str = "none"

    def run(self) -> None:
        """Returns when the page was closed, or after `close`."""
        if not self._pc.has_screen:
            self._say_words("window_no_screen", {})
        for backend in backends(self._pc):
            if self._closed.is_set() or self._try(backend):
                return
        self._give_address()

    def show(self) -> None:
        """Brings the window forward where there is one."""
        if self._window is not None:
            self._window.show()

    def close(self) -> None:
        """Makes `run` return."""
        self._closed.set()
        if self._window is not None:
            self._window.close()

    def _try(self, backend: Backend) -> bool:
        """Whether the page was shown and has been closed."""
        try:
            if backend.problem:
                raise NoWindowError(backend.problem, **backend.params)
            self.backend = backend.name
            if backend.name == "browser":
                self._show_in_browser()
            else:
                self._show_in_window(backend.name)
        except NoWindowError as error:
            if error.code not in _NO_NEWS:
                self._say_words(error.code, error.params)
            return False
        finally:
            self._window = None
        return True

    def _show_in_window(self, toolkit: Toolkit) -> None:
        # pywebview and GTK take half a second to import, and are not there on every PC
        from pinel_desktop.desktop.window import NativeWindow  # noqa: PLC0415

        window = NativeWindow(
            self._fresh_address,
            TITLE,
            self._language,
            icon=str(_ICON) if _ICON.is_file() else None,
            on_open=self._on_open,
        )
        self._window = window
        window.run(toolkit)

    def _show_in_browser(self) -> None:
        window = BrowserWindow(self._fresh_address, self._pc)
        self._window = window
        window.run()

    def _give_address(self) -> None:
        """The last way: the person opens the page; the app goes on until it is ended."""
        self.backend = "address"
        address = self._fresh_address()
        words = describe("window_address", {}, self._language())
        self._say(words.message)
        self._give(address)
        self._say(words.remedy)
        if self._pc.has_screen:
            webbrowser.open(address)
        # in steps, because Windows hears Ctrl+C only between them
        while not self._closed.wait(0.5):
            pass

    def _say_words(self, code: str, params: Mapping[str, object]) -> None:
        words = describe(code, params, self._language())
        self._say(words.line)
