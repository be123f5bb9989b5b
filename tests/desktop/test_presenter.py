"""The presenter tries each backend, prints a remedy for each failure, and finally prints the address."""

import itertools
import os
import stat
import threading
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from pinel_desktop.desktop.backends import Pc
from pinel_desktop.desktop.presenter import Presenter
from pinel_desktop.messages import describe


class PrintedLines(list[str]):
    """Collects printed lines; `wait_for` waits for a line that contains the text."""

    def __init__(self) -> None:
        super().__init__()
        self._changed = threading.Condition()

    def add(self, line: str) -> None:
        with self._changed:
            self.append(line)
            self._changed.notify_all()

    def wait_for(self, text: str) -> None:
        with self._changed:
            assert self._changed.wait_for(lambda: any(text in line for line in self), 20), self


@pytest.fixture
def printed() -> PrintedLines:
    return PrintedLines()


@pytest.fixture
def addresses() -> Callable[[], str]:
    numbers = itertools.count(1)
    return lambda: f"http://127.0.0.1:1/?key={next(numbers)}"


def pc_without_gtk(browser: str | None, *, screen: bool = True) -> Pc:
    return Pc(
        platform="linux",
        environ={"DISPLAY": ":0"} if screen else {},
        which=lambda name: browser,
        is_file=lambda path: False,
        gtk_problem=lambda: "no WebKit2 here",
        qt_problem=lambda: "PyQt6",
    )


def fake_browser(folder: Path, script: str) -> str:
    program = folder / "fake browser"
    program.write_text(f"#!/bin/sh\n{script}\n", "utf-8")
    program.chmod(program.stat().st_mode | stat.S_IXUSR)
    return str(program)


def test_without_a_screen_the_address_is_printed_and_the_app_stays(
    printed: PrintedLines, addresses: Callable[[], str]
) -> None:
    presenter = Presenter(
        addresses,
        lambda: "en",
        print_text=printed.add,
        give=printed.add,
        pc=pc_without_gtk(None, screen=False),
    )
    running = threading.Thread(target=presenter.run)
    running.start()
    printed.wait_for("Ctrl+C")
    assert running.is_alive()
    presenter.close()
    running.join(10)
    assert not running.is_alive()
    assert "There is no screen" in printed[0]
    assert "http://127.0.0.1:1/?key=1" in printed


def test_the_browser_takes_the_window_s_place_and_the_reason_is_said(
    printed: PrintedLines, addresses: Callable[[], str], tmp_path: Path
) -> None:
    browser = fake_browser(tmp_path, f'printf "%s\\n" "$@" >"{tmp_path}/called"')
    presenter = Presenter(
        addresses,
        lambda: "en",
        print_text=printed.add,
        give=printed.add,
        pc=pc_without_gtk(browser),
    )
    presenter.run()
    assert presenter.backend == "browser"
    called = (tmp_path / "called").read_text("utf-8").splitlines()
    assert called[0] == "--app=http://127.0.0.1:1/?key=1"
    assert printed == [
        "PINEL's own window does not open: the system's WebKit is missing or does not load (no WebKit2 here). "
        "Install or update it: sudo apt install python3-gi gir1.2-gtk-3.0 gir1.2-webkit2-4.1. "
        "If it stays so, install the newest PINEL (Manuals: “Install again”)."
    ]


def test_a_browser_that_dies_at_once_is_followed_by_an_address_of_its_own(
    printed: PrintedLines,
    addresses: Callable[[], str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    opened: list[str] = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    presenter = Presenter(
        addresses,
        lambda: "pt-BR",
        print_text=printed.add,
        give=printed.add,
        pc=pc_without_gtk(fake_browser(tmp_path, "exit 3")),
    )
    running = threading.Thread(target=presenter.run)
    running.start()
    printed.wait_for("Ctrl+C")
    presenter.close()
    running.join(10)
    assert "status 3" in printed[1]
    assert opened == ["http://127.0.0.1:1/?key=2"]


def test_closing_ends_the_browser(
    printed: PrintedLines, addresses: Callable[[], str], tmp_path: Path
) -> None:
    started = tmp_path / "began"
    os.mkfifo(started)
    browser = fake_browser(tmp_path, f'echo began >"{started}"; exec sleep 600')
    presenter = Presenter(
        addresses,
        lambda: "en",
        print_text=printed.add,
        give=printed.add,
        pc=pc_without_gtk(browser),
    )
    running = threading.Thread(target=presenter.run)
    running.start()
    started.read_text("utf-8")
    presenter.close()
    running.join(10)
    assert not running.is_alive()


def test_bringing_a_browser_forward_waits_for_no_address(
    printed: PrintedLines, tmp_path: Path
) -> None:
    """The address comes on the thread that asks for the window."""
    numbers, released, called = itertools.count(1), threading.Event(), tmp_path / "called"

    def address() -> str:
        number = next(numbers)
        assert number == 1 or released.wait(10)
        return f"http://127.0.0.1:1/?key={number}"

    def n_opened() -> int:
        return len(called.read_text("utf-8").splitlines()) if called.exists() else 0

    def wait_for(n: int) -> None:
        deadline_s = time.monotonic() + 20
        while n_opened() < n:
            assert time.monotonic() < deadline_s
            time.sleep(0.02)

    script = f'echo "$1" >>"{called}"; case "$1" in *key=1) exec sleep 600;; esac'
    presenter = Presenter(
        address,
        lambda: "en",
        print_text=printed.add,
        give=printed.add,
        pc=pc_without_gtk(fake_browser(tmp_path, script)),
    )
    running = threading.Thread(target=presenter.run, daemon=True)
    running.start()
    wait_for(1)
    presenter.show()
    released.set()
    wait_for(2)
    presenter.close()
    running.join(10)
    assert not running.is_alive()


def test_closing_while_the_browser_starts_ends_it(printed: PrintedLines, tmp_path: Path) -> None:
    def address() -> str:
        presenter.close()
        return "http://127.0.0.1:1/?key=1"

    presenter = Presenter(
        address,
        lambda: "en",
        print_text=printed.add,
        give=printed.add,
        pc=pc_without_gtk(fake_browser(tmp_path, "exec sleep 600")),
    )
    running = threading.Thread(target=presenter.run, daemon=True)
    running.start()
    running.join(10)
    assert not running.is_alive()


@pytest.mark.parametrize("language", ["pt-BR", "en", "es"])
def test_every_failure_has_a_remedy_in_every_language(language: str) -> None:
    for code in (
        "window_gtk_missing", "window_qt_missing", "window_webview2_missing", "window_failed",
        "window_browser_missing", "window_no_screen", "screen_virtual_missing",
    ):  # fmt: skip
        text = describe(code, {"reason": "x", "backend": "y"}, language)
        assert text.message != code
        assert text.remedy
        assert "{" not in text.message + text.remedy
