"""The navigation policy of WebView2, on objects with the events of the real control. (It runs on Windows only.)"""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import pytest

from pinel_desktop.desktop.policy import decide_navigation
from pinel_desktop.desktop.webview2 import install_policy

OWN = "http://127.0.0.1:8400/?key=a#/program/1"


class Event:
    """An event of .NET: handlers are added with `+=`."""

    def __init__(self) -> None:
        self._handlers: list[Callable[[Any, Any], None]] = []

    def __iadd__(self, handler: Callable[[Any, Any], None]) -> "Event":
        self._handlers.append(handler)
        return self

    def fire(self, argument: Any) -> None:
        for handler in self._handlers:
            handler(self, argument)


@dataclass
class Navigation:
    Uri: str
    Cancel: bool = False


@dataclass
class Core:
    FrameNavigationStarting: Event = field(default_factory=Event)


@dataclass
class View:
    NavigationStarting: Event = field(default_factory=Event)
    CoreWebView2InitializationCompleted: Event = field(default_factory=Event)
    CoreWebView2: Core | None = None


@pytest.fixture
def view() -> View:
    view = View()
    install_policy(view, lambda address: decide_navigation(address, OWN))
    return view


ADDRESSES = {
    OWN: False,
    "about:blank": True,
    "http://127.0.0.1:8401/": True,
    "https://example.org/": True,
    "file:///C:/Windows/win.ini": True,
    "blob:http://127.0.0.1:8400/1": True,  # saved as a download, never shown
}


@pytest.mark.parametrize(("address", "is_refused"), ADDRESSES.items())
def test_the_page_stays_at_its_origin(view: View, address: str, is_refused: bool) -> None:
    navigation = Navigation(address)
    view.NavigationStarting.fire(navigation)
    assert navigation.Cancel == is_refused


@pytest.mark.parametrize(("address", "is_refused"), ADDRESSES.items())
def test_so_does_a_frame(view: View, address: str, is_refused: bool) -> None:
    view.CoreWebView2 = Core()
    view.CoreWebView2InitializationCompleted.fire(None)
    navigation = Navigation(address)
    view.CoreWebView2.FrameNavigationStarting.fire(navigation)
    assert navigation.Cancel == is_refused


def test_a_webview_that_failed_to_start_has_no_frames(view: View) -> None:
    view.CoreWebView2InitializationCompleted.fire(None)
    assert view.CoreWebView2 is None
