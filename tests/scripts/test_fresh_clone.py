"""A clone in an empty folder: `make run` as the README has it, twice."""

import os
import signal
import subprocess
import time
import urllib.request
from pathlib import Path

import pytest

pytestmark = [pytest.mark.nightly, pytest.mark.timeout(1200)]
ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def clone(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("Laboratório 1") / "pinel"
    subprocess.run(["git", "clone", "--quiet", str(ROOT), str(folder)], check=True)
    return folder


def seconds_until_served(clone: Path) -> float:
    """Runs `make run` without a screen, opens the address that it prints, and ends it."""
    without = {"DISPLAY", "WAYLAND_DISPLAY", "PYTHONPATH", "MAKEFLAGS", "MAKELEVEL"}
    environment = {name: value for name, value in os.environ.items() if name not in without}
    environment["PINEL_HOME"] = str(clone / "home")
    started = time.monotonic()
    with subprocess.Popen(
        ["make", "run"],
        cwd=clone,
        env=environment,
        stdout=subprocess.PIPE,
        text=True,
        start_new_session=True,
    ) as run:
        try:
            assert run.stdout is not None
            address = next(
                line.strip() for line in run.stdout if line.startswith("http://127.0.0.1:")
            )
            seconds = time.monotonic() - started
            opener = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
            with opener.open(address, timeout=20) as answer:
                assert b"<script" in answer.read()
        finally:
            os.killpg(run.pid, signal.SIGTERM)
    return seconds


def test_the_first_run_sets_everything_up_and_serves_the_page(clone: Path) -> None:
    assert seconds_until_served(clone) < 600


def test_the_second_run_starts_in_seconds(clone: Path) -> None:
    assert seconds_until_served(clone) < 10


def test_an_edit_in_the_page_builds_it_anew(clone: Path) -> None:
    page = clone / "pinel_desktop" / "web" / "static" / "index.html"
    (clone / "ui" / "index.html").touch()
    before = page.stat().st_mtime_ns
    seconds_until_served(clone)
    assert page.stat().st_mtime_ns > before
