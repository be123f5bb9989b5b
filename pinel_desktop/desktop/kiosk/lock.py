"""Locks GTK's window in kiosk mode: what the toolkit and WebKit would let a pupil do is refused."""

from typing import Any

from pinel_desktop.desktop.kiosk.mode import PrintPermission

_REGRAB_MS = 500
# GTK's pickers of emoji, which open over the page
_PICKER_KEYS = ("period", "semicolon")


def lock_window(view: Any, print_permission: PrintPermission) -> None:
    """Locks a window; docs/install.md says what only the operating system can lock.

    Args:
        view: pywebview's `BrowserView`, on its thread.
        print_permission: whether a print dialog may open.
    """
    from gi.repository import GLib  # noqa: PLC0415 - optional, see backends.gtk_problem

    window, page = view.window, view.webview
    window.set_decorated(False)
    window.set_keep_above(True)
    window.stick()
    window.connect("key-press-event", _refuse_picker)
    GLib.timeout_add(_REGRAB_MS, _grab_keyboard, window)

    def decide_print(_page: Any, _operation: Any) -> bool:
        return not print_permission.use()

    page.connect("print", decide_print)
    page.connect("run-file-chooser", _refuse_dialog)
    page.connect("run-color-chooser", _refuse_dialog)
    page.connect("permission-request", _refuse_permission)
    page.get_context().connect("download-started", _refuse_download)


def _grab_keyboard(window: Any) -> bool:
    """Takes the keys that the window manager would handle, such as Alt+Tab. Repeated, because menus end the grab."""
    from gi.repository import Gdk  # noqa: PLC0415

    seat = window.get_display().get_default_seat()
    is_grabbed = window.get_display().device_is_grabbed(seat.get_keyboard())
    if window.is_active() and not is_grabbed:
        seat.grab(window.get_window(), Gdk.SeatCapabilities.KEYBOARD, True, None, None, None)
    return window.get_window() is not None


def _refuse_picker(_window: Any, event: Any) -> bool:
    from gi.repository import Gdk  # noqa: PLC0415

    has_control = bool(event.state & Gdk.ModifierType.CONTROL_MASK)
    return has_control and Gdk.keyval_name(event.keyval) in _PICKER_KEYS


def _refuse_dialog(_page: Any, request: Any) -> bool:
    request.cancel()
    return True


def _refuse_permission(_page: Any, request: Any) -> bool:
    request.deny()
    return True


def _refuse_download(_context: Any, download: Any) -> None:
    download.cancel()
