"""The real window on a virtual screen: it opens the page, blocks other addresses, and closes at once."""

import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.desktop.screen import virtual_screen

pytestmark = pytest.mark.e2e
PROBE = [sys.executable, str(Path(__file__).with_name("window_probe.py"))]


@pytest.fixture(scope="module")
def screen() -> Iterator[str]:
    with virtual_screen() as display:
        yield display


@pytest.fixture(scope="module")
def found(screen: str) -> dict[str, Any]:
    done = subprocess.run(
        PROBE,
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


def test_the_window_shows_a_page_under_a_strict_policy(found: dict[str, Any]) -> None:
    assert found["ready"]


def test_the_window_fills_a_small_screen(found: dict[str, Any]) -> None:
    assert found["size"] == [1366, 768]


def test_no_script_and_no_link_leaves_the_page(found: dict[str, Any]) -> None:
    assert found["stranger_asked"] == 0
    assert found["address"] == found["own"]


def test_a_file_that_the_page_hands_out_is_saved_where_the_person_says(
    found: dict[str, Any],
) -> None:
    assert found["saved"] == "a world"


def test_the_page_may_be_loaded_again(found: dict[str, Any]) -> None:
    assert found["reloaded"]


def test_the_page_may_keep_small_settings(found: dict[str, Any]) -> None:
    assert found["storage"] == "yes"


def test_closing_asks_nothing_and_takes_less_than_two_seconds(found: dict[str, Any]) -> None:
    assert found["closing_s"] < 2


@pytest.mark.parametrize("how", [signal.SIGTERM, signal.SIGINT], ids=["SIGTERM", "SIGINT"])
def test_a_signal_closes_the_window_properly(screen: str, how: signal.Signals) -> None:
    with subprocess.Popen(
        [*PROBE, "--wait"], env=os.environ | {"DISPLAY": screen}, stdout=subprocess.PIPE, text=True
    ) as probe:
        assert probe.stdout is not None
        assert probe.stdout.readline() == "open\n"
        probe.send_signal(how)
        try:
            assert probe.wait(10) == 0
        finally:
            probe.kill()
        rest = probe.stdout.read()
    assert "own" in json.loads(rest)


def test_without_a_screen_that_answers_the_window_says_so() -> None:
    done = subprocess.run(
        PROBE,
        env=os.environ | {"DISPLAY": ":12345"},
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert "window_no_screen" in done.stderr
