"""The package itself: complete, and without what must not be in it. (The smoke test opens its window.)"""

import json
import os
import subprocess
import urllib.request
from pathlib import Path

import pytest

from tests.packaging.loading import ROOT

pytestmark = pytest.mark.packaged
FOLDER = ROOT / "dist" / "pinel-desktop"
PROGRAM = FOLDER / "pinel"


@pytest.fixture(scope="module", autouse=True)
def _package() -> None:
    assert PROGRAM.is_file(), "there is no package: make package"


def run(home: Path, *arguments: str) -> "subprocess.CompletedProcess[str]":
    environment = {"HOME": str(home), "PINEL_HOME": str(home), "LANG": "en_US.UTF-8"}
    return subprocess.run(
        [PROGRAM, *arguments],
        env=environment,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )


def test_the_page_the_worlds_and_the_words_are_inside() -> None:
    inside = FOLDER / "_internal"
    assert (inside / "pinel_desktop/web/static/index.html").is_file()
    assert (inside / "sim/worlds/empty_room.json").is_file()
    assert (inside / "pinel_desktop/messages/catalogue/pt-BR/app.json").is_file()


def test_the_bill_of_materials_names_what_ships() -> None:
    bom = json.loads((FOLDER / "pinel-desktop.cdx.json").read_text("utf-8"))
    names = {component["name"] for component in bom["components"]}
    assert {"Flask", "numpy", "onnxruntime", "blockly", "preact"} <= names
    assert not {"PyInstaller", "vite", "mypy"} & names


def test_the_manuals_are_inside_with_their_pictures() -> None:
    assets = FOLDER / "_internal/pinel_desktop/web/static/assets"
    scripts = [file.read_text("utf-8") for file in assets.glob("*.js")]
    assert any("Instalar nos computadores da escola" in script for script in scripts)
    assert list(assets.glob("lesson-plan-*.png"))


def test_the_notices_name_what_ships() -> None:
    text = (FOLDER / "THIRD-PARTY-NOTICES.txt").read_text("utf-8")
    for name in ("blockly", "Flask", "pymunk", "numpy", "SQLite", "Python"):
        assert f"{name} " in text or f"{name}:" in text


def test_the_desktop_s_libraries_stay_outside() -> None:
    names = {file.name for file in FOLDER.rglob("lib*.so*")}
    assert not [
        name for name in names if name.startswith(("libgtk", "libglib", "libwebkit", "libreadline"))
    ]


def test_no_path_of_the_machine_that_built_it_is_inside() -> None:
    """Neither the sources' folder nor the user's: the package is to work, and to look, the same anywhere."""
    where = str(ROOT).encode()
    texts = (
        file for file in FOLDER.rglob("*") if file.is_file() and file.suffix not in {".so", ".zip"}
    )
    assert not [file for file in texts if where in file.read_bytes()]


def test_a_program_runs_from_the_command_line(tmp_path: Path) -> None:
    done = run(tmp_path, "run", str(ROOT / "tests/programs/square.json"), "--json")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["state"] == "finished"


def test_a_plot_is_refused_with_what_to_install(tmp_path: Path) -> None:
    """Its library would be a third of the package, for one option of the command line."""
    square = str(ROOT / "tests/programs/square.json")
    done = run(tmp_path, "run", square, "--plot", str(tmp_path / "plot.png"))
    assert done.returncode == 2, done.stderr
    assert "pinel-desktop[plot]" in done.stdout
    assert not (FOLDER / "_internal" / "matplotlib").exists()


def test_the_network_of_real_robots_is_inside(tmp_path: Path) -> None:
    settings = ("--robot-setting", "domain=101", "--robot-setting", 'peers=["127.0.0.1"]')
    square = str(ROOT / "tests/programs/square.json")
    done = run(tmp_path, "run", square, "--json", "--no-store", "--robot", "dds", *settings)
    assert json.loads(done.stdout)["reason"] == "robot_not_found", done.stderr
    assert (FOLDER / "_internal/pinel_desktop/links/ros2/node/node.py").is_file()


def test_what_went_wrong_is_said_in_words(tmp_path: Path) -> None:
    done = run(tmp_path, "run", str(tmp_path / "no such file.json"))
    assert done.returncode == 2
    assert "no such file" in done.stdout


def test_the_doctor_finds_page_and_engine(tmp_path: Path) -> None:
    found = json.loads(run(tmp_path, "doctor", "--json").stdout)["findings"]
    levels = {finding["about"]: finding["level"] for finding in found}
    assert (levels["page"], levels["engine"]) == ("ok", "ok")


def test_the_page_is_served(tmp_path: Path) -> None:
    environment = os.environ | {"PINEL_HOME": str(tmp_path)}
    with subprocess.Popen(
        [PROGRAM, "serve"], env=environment, stdout=subprocess.PIPE, text=True
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
