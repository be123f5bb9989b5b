"""Which ways there are on this PC to show the page, best first, and what is missing for the others.

Nothing here opens anything or imports pywebview: `pinel doctor` asks as well.
"""

import importlib
import importlib.util
import os
import shutil
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Literal

from pinel_desktop.errors import PinelError

Toolkit = Literal["gtk", "qt", "edgechromium", "cocoa"]
BackendName = Toolkit | Literal["browser"]

# Names under which browsers that know `--app=ADDRESS` are installed; Windows keeps them off the PATH.
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
_WINDOWS_BROWSERS = (
    r"Microsoft\Edge\Application\msedge.exe",
    r"Google\Chrome\Application\chrome.exe",
    r"Chromium\Application\chrome.exe",
)


def gtk_problem() -> str | None:
    """What keeps GTK's web view from loading, in the library's words; None when it loads."""
    try:
        gi = importlib.import_module("gi")
        gi.require_version("Gtk", "3.0")
        try:
            gi.require_version("WebKit2", "4.1")
        except ValueError:
            gi.require_version("WebKit2", "4.0")
        importlib.import_module("gi.repository.WebKit2")
    except (ImportError, ValueError) as error:
        return str(error)
    return None


def qt_problem() -> str | None:
    """What keeps Qt's web view from loading; None when its parts are installed."""
    if importlib.util.find_spec("qtpy") is None:
        return "qtpy"
    for package in ("PyQt6", "PySide6"):
        if importlib.util.find_spec(package) is not None:
            return None
    return "PyQt6, PySide6"


class NoWindowError(PinelError):
    """The page cannot be shown in this way; another may be tried."""


@dataclass(frozen=True, slots=True)
class Pc:
    """What the choice depends on; tests describe other PCs with it."""

    platform: str = sys.platform
    environ: Mapping[str, str] = field(default_factory=lambda: os.environ)
    which: Callable[[str], str | None] = shutil.which
    is_file: Callable[[str], bool] = os.path.isfile
    gtk_problem: Callable[[], str | None] = gtk_problem
    qt_problem: Callable[[], str | None] = qt_problem

    @property
    def has_screen(self) -> bool:
        """Whether a window could be seen at all."""
        if self.platform in ("win32", "darwin"):
            return True
        return bool(self.environ.get("DISPLAY") or self.environ.get("WAYLAND_DISPLAY"))


@dataclass(frozen=True, slots=True)
class Backend:
    """One way to show the page; `problem` is the code of why it cannot, with its parameters."""

    name: BackendName
    problem: str | None = None
    params: Mapping[str, object] = field(default_factory=dict)


def find_browser(pc: Pc) -> str | None:
    """The program file of a browser that can show an address as an app of its own."""
    for name in BROWSERS:
        if path := pc.which(name):
            return path
    for variable in ("ProgramFiles(x86)", "ProgramFiles", "LocalAppData"):
        for path in _WINDOWS_BROWSERS if variable in pc.environ else ():
            if pc.is_file(candidate := os.path.join(pc.environ[variable], path)):
                return candidate
    return None


def backends(pc: Pc) -> list[Backend]:
    """Every way worth trying here in its order, those with a problem among them."""
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
    """Why what pywebview took must not be used: without WebView2 it falls back to Internet Explorer.

    MSHTML cannot run the page, and pywebview says no word about it.
    """
    return "window_webview2_missing" if renderer == "mshtml" else None
