"""The entry point `pinel`: opens the window at once, and dispatches subcommands."""

import ctypes
import subprocess
import sys
from types import SimpleNamespace

import pytest

from pinel_desktop import __main__, __version__
from pinel_desktop.commands import window
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import language_of_system


@pytest.mark.parametrize("database", [None, "7b.db"])
def test_without_a_command_the_window_opens(
    database: str | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[str | None] = []

    def open_app(db: str | None, *, kiosk: bool, place: str = "", file: str | None = None) -> int:
        asked.append(db)
        return 7

    monkeypatch.setattr(window, "open_app", open_app)
    monkeypatch.setattr(sys, "argv", ["pinel", *(["--db", database] if database else [])])
    with pytest.raises(SystemExit) as end:
        __main__.main()
    assert (asked, end.value.code) == ([database], 7)


@pytest.mark.parametrize("file", ["/stick/PC 07.pinel", "-h.PINEL"])
def test_with_a_bundle_the_window_opens_to_merge_it(
    file: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[str | None] = []
    monkeypatch.setattr(window, "open_app", lambda db, *, kiosk, file: asked.append(file))
    monkeypatch.setattr(sys, "argv", ["pinel", file])
    with pytest.raises(SystemExit):
        __main__.main()
    assert asked == [file]


def test_a_command_is_run(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "argv", ["pinel", "--version"])
    with pytest.raises(SystemExit) as end:
        __main__.main()
    assert end.value.code == 0
    assert __version__ in capsys.readouterr().out


def test_who_waits_for_the_window_waits_for_nothing_else() -> None:
    """What the window's process imports before the app's process is on its way."""
    heavy = {
        "click",
        "flask",
        "pydantic",
        "webview",
        "gi",
        "sqlite3",
        "pysqlite3",
        "filelock",
        "numpy",
    }
    assert not heavy & imported_with("pinel_desktop.__main__", "pinel_desktop.commands.window")


def test_the_app_starts_without_numpy() -> None:
    """No screen needs it to be drawn, and it takes a seventh of the start."""
    assert "numpy" not in imported_with("pinel_desktop.commands.app", "pinel_desktop.app")


def imported_with(*modules: str) -> set[str]:
    """The modules of a process that has imported these."""
    code = f"import sys, {', '.join(modules)}; print(*sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True
    )
    return set(done.stdout.split())


def test_a_command_ends_without_a_search_for_what_its_memory_still_holds() -> None:
    """It takes longer than many a command."""
    code = """
import gc, sys
from pinel_desktop.__main__ import main

class Kept:
    def __del__(self) -> None:
        sys.stdout.write("found")

gc.disable()
kept = Kept()
kept.itself = kept
del kept
sys.argv = ["pinel", "--version"]
main()
"""
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True
    )
    assert "found" not in done.stdout


@pytest.fixture
def windows(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """A Windows in Spanish; the texts of its message boxes."""
    shown: list[str] = []
    functions = SimpleNamespace(
        kernel32=SimpleNamespace(GetUserDefaultUILanguage=lambda: 0x0C0A),
        user32=SimpleNamespace(MessageBoxW=lambda _owner, text, *_: shown.append(text)),
    )
    for variable in ("PINEL_LANG", "LC_ALL", "LC_MESSAGES", "LANG"):
        monkeypatch.delenv(variable, raising=False)
    monkeypatch.setattr(ctypes, "windll", functions, raising=False)
    monkeypatch.setattr(sys, "platform", "win32")
    return shown


def test_the_language_is_that_of_windows(
    windows: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert language_of_system() == "es"
    monkeypatch.setenv("PINEL_LANG", "fr")
    assert language_of_system() == "fr"


def test_a_program_without_a_console_shows_why_it_does_not_start(
    windows: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "stderr", None)
    window._report_failure(PinelError("app_lost"))
    assert len(windows) == 1
    assert windows[0].startswith("PINEL se detuvo de repente.")
