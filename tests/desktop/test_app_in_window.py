"""The app in its real window: start, a second start that brings it forward, and closing it."""

import json
import os
import re
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from pinel_desktop.desktop.screen import virtual_screen
from tests.desktop.window_manager import window_manager
from tests.in_time import in_time

pytestmark = pytest.mark.e2e
PINEL = [sys.executable, "-m", "pinel_desktop"]
TITLE = "^PINEL Desktop$"
_FOUND_WITHIN_S = 60.0


class Desktop:
    """A virtual screen with a window manager, and actions on its windows."""

    def __init__(self, display: str, home: Path) -> None:
        self.environment = os.environ | {
            "DISPLAY": display,
            "PINEL_HOME": str(home),
            "LANG": "en_US.UTF-8",
        }

    def do(self, *arguments: str) -> None:
        """One call of xdotool; with --sync it waits for what it asks for."""
        done = self._xdotool(*arguments)
        assert done.returncode == 0, done.stderr

    def visible_window(self) -> str:
        """Waits until PINEL's window can be seen. A search fails, too, where a window goes while it looks at it."""
        deadline_s = time.monotonic() + _FOUND_WITHIN_S
        while not (found := self._xdotool("search", "--onlyvisible", "--name", TITLE).stdout):
            assert time.monotonic() < deadline_s
            time.sleep(0.1)
        return found.splitlines()[0]

    def _xdotool(self, *arguments: str) -> "subprocess.CompletedProcess[str]":
        return subprocess.run(
            ["xdotool", *arguments],
            env=self.environment,
            capture_output=True,
            text=True,
            timeout=60,
            check=False,
        )

    def start(self) -> "subprocess.Popen[str]":
        return subprocess.Popen(
            PINEL, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
        )


@pytest.fixture(scope="module")
def screen() -> Iterator[str]:
    with virtual_screen() as display, window_manager(display):
        yield display


@pytest.fixture
def desktop(screen: str, tmp_path: Path) -> Desktop:
    return Desktop(screen, tmp_path)


def test_a_second_start_brings_the_first_window_forward_and_closing_ends_everything(
    desktop: Desktop,
) -> None:
    with desktop.start() as first:
        try:
            window = desktop.visible_window()
            desktop.do("windowminimize", "--sync", window)
            with desktop.start() as second:
                out, err = second.communicate(timeout=30)
            assert second.returncode == 0
            assert "already open" in err
            assert re.fullmatch(r"http://127\.0\.0\.1:\d+/\?key=\S+", out.strip())
            assert desktop.visible_window() == window
            desktop.do("windowactivate", "--sync", window)
            asked = time.monotonic()
            desktop.do("key", "--window", "0", "alt+F4")
            assert first.wait(60) == 0
            assert in_time(time.monotonic() - asked, 2.5)
        finally:
            first.kill()
    assert not list(Path(desktop.environment["PINEL_HOME"]).glob("*.instance.json"))


@pytest.mark.timeout(300)
def test_a_page_whose_process_is_killed_comes_back_at_its_place(
    screen: str, tmp_path: Path
) -> None:
    probe = str(Path(__file__).with_name("crash_probe.py"))
    done = subprocess.run(
        [sys.executable, probe, str(tmp_path / "pinel.db")],
        env=os.environ | {"DISPLAY": screen},
        capture_output=True,
        text=True,
        timeout=250,  # a busy PC
        check=False,
    )
    found = json.loads(done.stdout.splitlines()[-1])
    assert "error" not in found, found
    assert found["before"][0] == "#/teacher"
    assert found["after"] == found["before"]


@pytest.mark.timeout(400)
def test_the_self_check_drives_the_square_with_the_window_open(screen: str, tmp_path: Path) -> None:
    environment = os.environ | {"DISPLAY": screen, "PINEL_HOME": str(tmp_path)}
    done = subprocess.run(
        [*PINEL, "--self-check"],
        env=environment,
        capture_output=True,
        text=True,
        timeout=300,  # a busy PC
        check=False,
    )
    found = json.loads(done.stdout)
    assert (done.returncode, found["ok"]) == (0, True), found
    assert found["window"]["backend"] == "gtk"
    assert found["run"]["duration_s"] <= 17
    assert found["store"]["ticks"] == pytest.approx(30 * found["run"]["duration_s"], abs=2)
    assert not list(tmp_path.iterdir()), "the person's own data folder is not for trying things"


def test_the_self_check_answers_with_an_object_even_when_the_window_fails(tmp_path: Path) -> None:
    environment = os.environ | {
        "DISPLAY": ":12345",
        "PINEL_HOME": str(tmp_path),
        "LANG": "en_US.UTF-8",
    }
    done = subprocess.run(
        [*PINEL, "--self-check"],
        env=environment,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    found = json.loads(done.stdout)
    assert (done.returncode, found["ok"]) == (1, False)
    assert found["error"]["code"] == "window_no_screen"
    assert found["error"]["remedy"]
