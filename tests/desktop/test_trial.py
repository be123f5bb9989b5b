"""The doctor's try of the window: it tells whether a page is shown, and why not."""

import socket
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from pinel_desktop.desktop import trial
from pinel_desktop.desktop.screen import virtual_screen

WEBKIT = "libwebkit2gtk-4.1.so.0"


@pytest.fixture
def screen(monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    with virtual_screen() as display:
        monkeypatch.setenv("DISPLAY", display)
        monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
        yield display


def instead(monkeypatch: pytest.MonkeyPatch, code: str) -> None:
    """Lets a process that does only this stand in for the one with the window."""
    monkeypatch.setattr(trial, "own_command", lambda *_: [sys.executable, "-c", code])


@pytest.mark.e2e
@pytest.mark.usefixtures("screen")
def test_a_window_that_shows_a_page_has_no_problem() -> None:
    assert trial.window_problem("gtk") is None


@pytest.mark.e2e
@pytest.mark.usefixtures("screen")
def test_a_webkit_that_does_not_load_is_found_though_its_bindings_do(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / WEBKIT).write_text("not a library")
    monkeypatch.setenv("LD_LIBRARY_PATH", str(tmp_path))
    problem = trial.window_problem("gtk")
    assert problem is not None
    assert problem.code == "doctor_window_failed"


@pytest.mark.e2e
def test_a_screen_that_does_not_answer_is_the_reason(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DISPLAY", ":12345")
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    problem = trial.window_problem("gtk")
    assert problem is not None
    assert problem.code == "window_no_screen"


def test_a_toolkit_that_ends_the_process_is_told_by_its_last_words(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    instead(monkeypatch, "import os; os.write(2, b'first\\nno such symbol\\n'); os.abort()")
    problem = trial.window_problem("gtk")
    assert problem is not None
    assert (problem.code, problem.params["reason"]) == ("doctor_window_failed", "no such symbol")


def test_a_window_that_hangs_is_ended(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(trial, "_SPARE_S", 0.0)
    instead(monkeypatch, "import threading; threading.Event().wait()")
    problem = trial.window_problem("gtk", timeout_s=0.5)
    assert problem is not None
    assert problem.code == "doctor_window_silent"


def test_no_name_server_is_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    """Some systems have no file of host names, and asked the network for the name of the loopback address."""
    asked: list[str] = []
    monkeypatch.setattr(socket, "getfqdn", asked.append)
    with trial._server(threading.Event()) as server:
        assert server.server_port == server.server_address[1]
    assert asked == []
