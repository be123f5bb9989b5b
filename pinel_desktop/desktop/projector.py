"""A window that fills a second screen, such as a projector. Only with GTK: elsewhere it could open another address."""

from collections.abc import Callable

import webview

from pinel_desktop.desktop.gtk_window import GtkWindow
from pinel_desktop.desktop.policy import NavigationDecision, second_screen


class ProjectorWindow:
    """Shows a page on a screen that does not show the main window. Not for the window's thread."""

    def __init__(
        self, title: str, background: str, judge: Callable[[str], NavigationDecision]
    ) -> None:
        self._title = title
        self._background = background
        self._judge = judge
        self._window: webview.Window | None = None

    def show(self, address: str, main: webview.Window) -> bool:
        """Shows an address in place of the one before. Returns False if there is no second screen."""
        if webview.renderer != "gtkwebkit2":
            return False
        from gi.repository import GLib  # noqa: PLC0415 - optional, see backends.gtk_problem

        centre = (main.x + main.width // 2, main.y + main.height // 2)
        screens = list(webview.screens)  # pywebview lists them again at each access
        screen = second_screen(screens, centre)
        if screen is None:
            return False
        self.close()
        self._window = webview.create_window(
            self._title,
            html=" ",  # the page follows when its navigation is guarded
            width=screen.width,
            height=screen.height,
            screen=screen,
            background_color=self._background,
        )
        # after pywebview's own call, which makes the window
        GLib.idle_add(self._fill, self._window, address, screens.index(screen))
        return True

    def close(self) -> None:
        """Closes the window, if it is open."""
        window, self._window = self._window, None
        if window is not None and window in webview.windows:
            window.destroy()

    def _fill(self, window: webview.Window, address: str, monitor: int) -> None:
        gtk = GtkWindow(window)
        gtk.guard_navigation(self._judge)
        gtk.fill_screen(monitor)
        gtk.load(address)
