"""Backends for showing the page on this PC, best first, and the missing part of each unusable backend.

Nothing here opens a window or imports pywebview, because `pinel doctor` uses it too.
"""

import ctypes
import importlib
import importlib.util
import os
import re
import shutil
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

from pinel_desktop.errors import PinelError

Toolkit = Literal["gtk", "qt", "edgechromium", "cocoa"]
BackendName = Toolkit | Literal["browser"]

# Program names of browsers that support `--app=ADDRESS`; on Windows they are not on the PATH.
BROWSERS = (
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "microsoft-edge",
    "microsoft-edge-stable",
    "msedge",
    "chrome",
    "brave-browser",
)
_WEBKIT_LIBRARIES = {"4.1": "libwebkit2gtk-4.1.so.0", "4.0": "libwebkit2gtk-4.0.so.37"}
# matches folders, to shorten a library's path to its name in messages; folders may contain spaces
_FOLDERS = re.compile(r"(?:/[^/:]*)+/")
_WINDOWS_BROWSERS = (
    r"Microsoft\Edge\Application\msedge.exe",
    r"Google\Chrome\Application\chrome.exe",
    r"Chromium\Application\chrome.exe",
)


def gtk_problem() -> str | None:
    """Returns the library's error if GTK's web view does not load; None if it does."""
    try:
        gi = importlib.import_module("gi")
        gi.require_version("Gtk", "3.0")
        try:
            gi.require_version("WebKit2", "4.1")
        except ValueError:
            gi.require_version("WebKit2", "4.0")
        # the bindings load even without the library, and fail later
        ctypes.CDLL(_WEBKIT_LIBRARIES[gi.get_required_version("WebKit2")])
        importlib.import_module("gi.repository.WebKit2")
    except (ImportError, ValueError) as error:
        return str(error)
    except OSError as error:  # the package's own loader wraps the system's message
        return _FOLDERS.sub("", str(error.__cause__ or error))
    return None


def qt_problem() -> str | None:
    """Returns the missing module if Qt's web view is not installed; None if it is."""
    if importlib.util.find_spec("qtpy") is None:
        return "qtpy"
    for package in ("PyQt6", "PySide6"):
        if importlib.util.find_spec(package) is not None:
            return None
    return "PyQt6, PySide6"


def has_graphics_device(folder: Path = Path("/dev/dri")) -> bool:
    """Returns whether Linux has a device for OpenGL; without one, the processor would compute it."""
    return any(folder.glob("renderD*"))


class NoWindowError(PinelError):
    """A backend cannot show the page; another may be tried."""


@dataclass(frozen=True, slots=True)
class Pc:
    """The properties of a PC on which the choice of backends depends; tests replace them."""

    platform: str = sys.platform
    environ: Mapping[str, str] = field(default_factory=lambda: os.environ)
    which: Callable[[str], str | None] = shutil.which
    is_file: Callable[[str], bool] = os.path.isfile
    gtk_problem: Callable[[], str | None] = gtk_problem
    qt_problem: Callable[[], str | None] = qt_problem

    @property
    def has_screen(self) -> bool:
        """True if the PC has a display."""
        if self.platform in ("win32", "darwin"):
            return True
        return bool(self.environ.get("DISPLAY") or self.environ.get("WAYLAND_DISPLAY"))


@dataclass(frozen=True, slots=True)
class Backend:
    """One backend; `problem` and `params` are the error if it cannot be used."""

    name: BackendName
    problem: str | None = None
    params: Mapping[str, object] = field(default_factory=dict)


def find_browser(pc: Pc) -> str | None:
    """Returns the path of a browser that supports app mode; None if there is none."""
    for name in BROWSERS:
        if path := pc.which(name):
            return path
    for variable in ("ProgramFiles(x86)", "ProgramFiles", "LocalAppData"):
        for path in _WINDOWS_BROWSERS if variable in pc.environ else ():
            if pc.is_file(candidate := os.path.join(pc.environ[variable], path)):
                return candidate
    return None


def backends(pc: Pc) -> list[Backend]:
    """Returns the backends for this PC, best first, including backends with a problem."""
    if not pc.has_screen:
        return []
    browser = Backend("browser", None if find_browser(pc) else "window_browser_missing")
    if pc.platform == "win32":
        return [Backend("edgechromium"), browser]
    if pc.platform == "darwin":
        return [Backend("cocoa"), browser]
    return [_gtk(pc), _qt(pc), browser]


def _gtk(pc: Pc) -> Backend:
    reason = pc.gtk_problem()
    return Backend("gtk", "window_gtk_missing", {"reason": reason}) if reason else Backend("gtk")


def _qt(pc: Pc) -> Backend:
    reason = pc.qt_problem()
    return Backend("qt", "window_qt_missing", {"reason": reason}) if reason else Backend("qt")


def renderer_problem(renderer: str) -> str | None:
    """Returns the error code if pywebview's renderer cannot run the page, else None.

    Without WebView2, pywebview falls back to Internet Explorer (MSHTML) without an error.
    """
    return "window_webview2_missing" if renderer == "mshtml" else None
