"""The wheel, built from the source distribution: it installs, and serves its page."""

import os
import re
import subprocess
import sys
import urllib.request
import zipfile
from collections.abc import Iterator
from importlib import metadata
from pathlib import Path

import pytest

from tests.packaging.loading import ROOT

pytestmark = pytest.mark.packaged


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Built by way of the source distribution: what that lacks, the wheel lacks."""
    folder = tmp_path_factory.mktemp("wheel")
    command = [sys.executable, "-m", "build", "--no-isolation", "--outdir", str(folder), str(ROOT)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return next(folder.glob("*.whl"))


def needed_at_run_time() -> Iterator[metadata.Distribution]:
    """What requirements.lock installs here; nothing of the development tools."""
    lock = (ROOT / "requirements.lock").read_text("utf-8")
    for name in re.findall(r"^([\w.-]+)==", lock, re.M):
        try:
            yield metadata.distribution(name)
        except metadata.PackageNotFoundError:
            continue  # for another platform


@pytest.fixture(scope="module")
def environment(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A new environment with the wheel and its dependencies, linked from ours so that no network is needed."""
    folder = tmp_path_factory.mktemp("installed") / "env"
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", str(folder)], check=True)
    python = folder / "bin" / "python"
    asked = subprocess.run(
        [python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    packages = Path(asked.stdout.strip())
    for distribution in needed_at_run_time():
        for top in {
            Path(file).parts[0] for file in distribution.files or () if ".." not in str(file)
        }:
            source = Path(str(distribution.locate_file(top)))
            if source.exists() and not (packages / top).exists():
                (packages / top).symlink_to(source)
    install = [
        sys.executable,
        "-m",
        "pip",
        "--python",
        str(python),
        "install",
        "-qq",
        "--no-deps",
        "--no-index",
    ]
    subprocess.run([*install, str(wheel)], check=True)
    return folder


def test_the_wheel_holds_page_worlds_words_and_licence(wheel: Path) -> None:
    names = set(zipfile.ZipFile(wheel).namelist())
    for name in (
        "pinel_desktop/web/static/index.html",
        "pinel_desktop/messages/catalogue/pt-BR/app.json",
        "pinel_desktop/gestures/weights/hand.onnx",
        "pinel_desktop/gestures/weights/letters.npz",
        "pinel_desktop/py.typed",
        "sim/worlds/empty_room.json",
    ):
        assert name in names
    assert any(name.endswith("licenses/LICENSE") for name in names)


def test_the_wheel_holds_nothing_but_the_three_packages(wheel: Path) -> None:
    tops = {name.partition("/")[0] for name in zipfile.ZipFile(wheel).namelist()}
    assert {top for top in tops if not top.endswith(".dist-info")} == {
        "pinel_desktop",
        "sim",
        "storage",
    }


def test_the_installed_command_serves_the_page(environment: Path, tmp_path: Path) -> None:
    variables = {"PATH": os.environ["PATH"], "PINEL_HOME": str(tmp_path), "HOME": str(tmp_path)}
    command = [str(environment / "bin" / "pinel"), "serve"]
    with subprocess.Popen(
        command, env=variables, cwd=tmp_path, stdout=subprocess.PIPE, text=True
    ) as served:
        try:
            assert served.stdout is not None
            address = served.stdout.readline().strip()
            opener = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
            with opener.open(address, timeout=20) as answer:
                assert b"<script" in answer.read()
        finally:
            served.terminate()
        assert served.wait(20) == 0


def test_the_installed_command_runs_the_square(environment: Path, tmp_path: Path) -> None:
    variables = {"PATH": os.environ["PATH"], "PINEL_HOME": str(tmp_path), "HOME": str(tmp_path)}
    square = str(ROOT / "tests" / "programs" / "square.json")
    command = [str(environment / "bin" / "pinel"), "run", square, "--json"]
    done = subprocess.run(
        command, env=variables, cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
