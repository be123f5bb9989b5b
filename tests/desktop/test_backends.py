"""Which backends are tried on which PC."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from pinel_desktop.desktop.backends import (
    Pc,
    backends,
    find_browser,
    has_graphics_device,
    renderer_problem,
)


def pc_with(
    *programs: str,
    platform: str = "linux",
    screen: bool = True,
    gtk: str | None = None,
    qt: str | None = "PyQt6",
) -> Pc:
    return Pc(
        platform=platform,
        environ={"DISPLAY": ":0"} if screen else {},
        which=lambda name: f"/usr/bin/{name}" if name in programs else None,
        is_file=lambda path: False,
        gtk_problem=lambda: gtk,
        qt_problem=lambda: qt,
    )


def usable(pc: Pc) -> list[str]:
    return [backend.name for backend in backends(pc) if backend.problem is None]


def test_linux_tries_the_system_s_web_view_then_a_browser() -> None:
    assert usable(pc_with("chromium")) == ["gtk", "browser"]


def test_qt_is_tried_between_them_where_it_is_installed() -> None:
    assert usable(pc_with("chromium", qt=None)) == ["gtk", "qt", "browser"]


def test_what_is_missing_is_kept_with_its_reason() -> None:
    gtk = backends(pc_with(gtk="no WebKit2"))[0]
    assert (gtk.problem, dict(gtk.params)) == ("window_gtk_missing", {"reason": "no WebKit2"})


def test_a_pc_without_any_browser_says_so_last() -> None:
    assert backends(pc_with())[-1].problem == "window_browser_missing"


def test_without_a_screen_no_window_is_tried() -> None:
    assert backends(pc_with("chromium", screen=False)) == []


@pytest.mark.parametrize(("platform", "first"), [("win32", "edgechromium"), ("darwin", "cocoa")])
def test_other_systems_use_their_own_web_view_and_always_have_a_screen(
    platform: str, first: str
) -> None:
    assert backends(pc_with(platform=platform, screen=False))[0].name == first


def test_wayland_counts_as_a_screen() -> None:
    assert Pc(platform="linux", environ={"WAYLAND_DISPLAY": "wayland-0"}).has_screen


def test_the_first_known_browser_is_taken() -> None:
    assert find_browser(pc_with("microsoft-edge", "google-chrome")) == "/usr/bin/google-chrome"


def test_windows_keeps_edge_off_the_path() -> None:
    pc = Pc(
        platform="win32",
        environ={"ProgramFiles(x86)": r"C:\Program Files (x86)"},
        which=lambda name: None,
        is_file=lambda path: path.endswith("msedge.exe"),
    )
    assert str(find_browser(pc)).endswith("msedge.exe")


def test_internet_explorer_is_refused_with_the_advice_to_install_webview2() -> None:
    assert renderer_problem("mshtml") == "window_webview2_missing"
    assert renderer_problem("edgechromium") is None
    assert renderer_problem("gtkwebkit2") is None


@pytest.mark.skipif(sys.platform != "linux", reason="asks for the bindings of the test machine")
def test_the_test_machine_has_the_system_s_web_view() -> None:
    assert Pc().gtk_problem() is None


@pytest.mark.skipif(sys.platform != "linux", reason="asks for the bindings of the test machine")
@pytest.mark.parametrize("folder", ["lib", "PINEL (cópia) 1/_internal"])
def test_a_web_view_whose_library_does_not_load_is_a_problem_in_the_loader_s_words(
    tmp_path: Path, folder: str
) -> None:
    """Its bindings load all the same: they warn, and fail when a function is called."""
    libraries = tmp_path / folder
    libraries.mkdir(parents=True)
    (libraries / "libwebkit2gtk-4.1.so.0").write_text("not a library")
    code = "from pinel_desktop.desktop.backends import gtk_problem; print(gtk_problem())"
    done = subprocess.run(
        [sys.executable, "-c", code],
        env=os.environ | {"LD_LIBRARY_PATH": str(libraries), "PYTHONUTF8": "1"},
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
    )
    assert done.stdout == "libwebkit2gtk-4.1.so.0: file too short\n"


def test_a_graphics_device_is_what_linux_draws_with_and_not_any_screen(tmp_path: Path) -> None:
    assert not has_graphics_device(tmp_path / "absent")
    (tmp_path / "card0").touch()
    assert not has_graphics_device(tmp_path)
    (tmp_path / "renderD128").touch()
    assert has_graphics_device(tmp_path)
