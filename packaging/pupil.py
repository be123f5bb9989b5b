"""A pupil at the screen of another system: reads the page as a screen reader does, and clicks as a mouse does.

The names and places of the page's elements come from AT-SPI, the accessibility interface of WebKitGTK. The clicks and
keys are events of the X server, by xdotool.
"""

import contextlib
import os
import subprocess
import time
from collections.abc import Iterator
from typing import Any

from gi.repository import Gio, GLib

_CACHE = "/org/a11y/atspi/cache"
_NAME = GLib.Variant("(ss)", ("org.a11y.atspi.Accessible", "Name"))
_ON_SCREEN = GLib.Variant("(u)", (0,))
_CALL_MS = 10_000
_WITHIN_S = 240.0
_PERIOD_S = 0.5
Reference = tuple[str, str]  # an element: name on the bus, object path
Element = tuple[str, tuple[int, int, int, int]]  # accessible name; x, y, width and height in pixels


class Pupil:
    """Works on the page of the only WebKit window of a screen.

    Args:
        user: whose session it is; root may not use its D-Bus.
        environment: of the session, with DISPLAY and DBUS_SESSION_BUS_ADDRESS.
    """

    def __init__(self, user: int, environment: dict[str, str]) -> None:
        self._environment = environment
        os.seteuid(user)
        try:
            session = _connection(environment["DBUS_SESSION_BUS_ADDRESS"])
            (address,) = _call(session, "org.a11y.Bus", "/org/a11y/bus", "org.a11y.Bus.GetAddress")
            self._bus = _connection(address)
        finally:
            os.seteuid(0)

    def click(self, name: str) -> None:
        """Clicks on the middle of the first element whose accessible name contains `name`, once it is there to stay."""
        before, place = None, self.find(name)
        while place != before:  # on a busy PC, another element may still push it aside
            time.sleep(_PERIOD_S)
            before, place = place, self.find(name)
        x, y, width, height = place
        middle = (str(x + width // 2), str(y + height // 2))
        self._xdotool("mousemove", *middle, "click", "1")

    def write(self, text: str) -> None:
        """Types a text."""
        self._xdotool("type", text)

    def find(self, name: str) -> tuple[int, int, int, int]:
        """Returns the place of an element, once it is there; raises TimeoutError with the names that are."""
        deadline = time.monotonic() + _WITHIN_S
        while time.monotonic() < deadline:
            seen = list(self._elements())
            for found, place in seen:
                if name in found:
                    return place
            time.sleep(_PERIOD_S)
        raise TimeoutError(f"{name} is not among {[found for found, _ in seen if found]}")

    def is_shown(self, name: str) -> bool:
        """Returns True once an element is there; raises TimeoutError as `find` does."""
        return bool(self.find(name))

    def _elements(self) -> Iterator[Element]:
        (names,) = self._ask(("org.freedesktop.DBus", "/"), "org.freedesktop.DBus.ListNames")
        for name in names:
            with contextlib.suppress(GLib.Error):  # no page
                (items,) = self._ask((name, _CACHE), "org.a11y.atspi.Cache.GetItems")
                for item in items[:1]:
                    yield from self._below(item[0])

    def _below(self, element: Reference) -> Iterator[Element]:
        with contextlib.suppress(GLib.Error):  # the element has gone meanwhile
            (name,) = self._ask(element, "org.freedesktop.DBus.Properties.Get", _NAME)
            (place,) = self._ask(element, "org.a11y.atspi.Component.GetExtents", _ON_SCREEN)
            yield name, place
            (children,) = self._ask(element, "org.a11y.atspi.Accessible.GetChildren")
            for child in children:
                yield from self._below(child)

    def _ask(self, element: Reference, method: str, arguments: GLib.Variant = None) -> Any:
        return _call(self._bus, *element, method, arguments)

    def _xdotool(self, *arguments: str) -> None:
        subprocess.run(["/usr/bin/xdotool", *arguments], env=self._environment, check=True)


def prepare() -> None:
    """Loads what D-Bus needs; call it before the root folder changes."""
    with contextlib.suppress(GLib.Error):
        _connection("unix:path=/nowhere")


def _connection(address: str) -> Gio.DBusConnection:
    flags = Gio.DBusConnectionFlags
    kind = flags.AUTHENTICATION_CLIENT | flags.MESSAGE_BUS_CONNECTION
    return Gio.DBusConnection.new_for_address_sync(address, kind, None, None)


def _call(
    bus: Gio.DBusConnection, name: str, path: str, method: str, arguments: GLib.Variant = None
) -> Any:
    interface, _, member = method.rpartition(".")
    answer = bus.call_sync(name, path, interface, member, arguments, None, 0, _CALL_MS, None)
    return answer.unpack()
