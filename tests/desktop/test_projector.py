"""The second window, for real on a virtual screen: it fills its screen, shows only the page, ends with the first."""

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.desktop.policy import second_screen
from pinel_desktop.desktop.screen import virtual_screen
from tests.desktop.window_manager import window_manager

WIDTH, HEIGHT = 1024, 768
ROOT = Path(__file__).parents[2]


@dataclass
class Area:
    x: int
    y: int
    width: int
    height: int


LEFT, RIGHT = Area(0, 0, WIDTH, HEIGHT), Area(WIDTH, 0, 1920, 1080)


@pytest.mark.parametrize(
    ("screens", "at", "second"),
    [
        ([LEFT], (500, 300), None),
        ([LEFT, RIGHT], (500, 300), RIGHT),
        ([LEFT, RIGHT], (1500, 300), LEFT),
        ([LEFT, LEFT], (500, 300), None),
    ],
    ids=["one", "right", "left", "mirrored"],
)
def test_the_second_screen_is_one_that_the_first_window_is_not_on(
    screens: list[Area], at: tuple[int, int], second: Area | None
) -> None:
    assert second_screen(screens, at) == second


@pytest.fixture(scope="module")
def screen() -> Iterator[str]:
    with virtual_screen(WIDTH, HEIGHT) as display, window_manager(display):
        yield display


def probe(screen: str, *options: str) -> dict[str, Any]:
    done = subprocess.run(
        [sys.executable, "-m", "tests.desktop.projector_probe", *options],
        cwd=ROOT,
        env=os.environ | {"DISPLAY": screen},
        capture_output=True,
        text=True,
        timeout=90,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    answer: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    assert "error" not in answer, answer
    return answer


@pytest.mark.e2e
def test_a_page_is_presented_in_a_second_window_that_fills_its_screen(screen: str) -> None:
    found = probe(screen)
    assert found["presented"] is True
    assert found["size"] == [WIDTH, HEIGHT]
    assert found["stranger_asked"] == 0
    assert found["n_windows"] == 2
    assert found["ended"]


@pytest.mark.e2e
@pytest.mark.parametrize("option", ["--one-screen", "--kiosk"])
def test_with_one_screen_and_in_kiosk_mode_no_second_window_opens(screen: str, option: str) -> None:
    assert probe(screen, option)["presented"] is False
