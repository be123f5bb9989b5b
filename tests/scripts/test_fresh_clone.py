"""A clone in an empty folder: `make run` as the README has it, twice."""

import os
import signal
import subprocess
import urllib.request
from pathlib import Path

import pytest

pytestmark = [pytest.mark.nightly, pytest.mark.timeout(1200)]
MADE = (
    ".venv/.ready-run",
    "ui/node_modules/.package-lock.json",
    "pinel_desktop/web/static/index.html",
    "pinel_desktop/gestures/weights/hand.onnx",
)
ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def clone(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("Laboratório 1") / "pinel"
    subprocess.run(["git", "clone", "--quiet", str(ROOT), str(folder)], check=True)
    return folder


def serve(clone: Path) -> None:
    """Runs `make run` without a screen, opens the address that it prints, and ends it."""
    without = {"DISPLAY", "WAYLAND_DISPLAY", "PYTHONPATH", "MAKEFLAGS", "MAKELEVEL"}
    environment = {name: value for name, value in os.environ.items() if name not in without}
    environment["PINEL_HOME"] = str(clone / "home")
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
            opener = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
            with opener.open(address, timeout=20) as answer:
                assert b"<script" in answer.read()
        finally:
            os.killpg(run.pid, signal.SIGTERM)


def test_the_first_run_sets_everything_up_and_serves_the_page(clone: Path) -> None:
    serve(clone)


def made(clone: Path) -> dict[str, int]:
    """When each thing was made that `make run` needs."""
    found = (clone / name for name in MADE)
    return {file.name: file.stat().st_mtime_ns for file in found}


def test_the_second_run_makes_nothing_anew(clone: Path) -> None:
    before = made(clone)
    serve(clone)
    assert made(clone) == before


def test_an_edit_in_the_page_builds_it_anew(clone: Path) -> None:
    page = clone / "pinel_desktop" / "web" / "static" / "index.html"
    (clone / "ui" / "index.html").touch()
    before = page.stat().st_mtime_ns
    serve(clone)
    assert page.stat().st_mtime_ns > before
