"""`pinel run --plot`."""

import json
import sys
from pathlib import Path

import pytest

from pinel_desktop.execution.executor import RunOptions, execute
from pinel_desktop.links import open_link
from pinel_desktop.program.reading import read_document
from pinel_desktop.runs.plotting import Curves
from tests.commands.typed import PROGRAMS, SQUARE, pinel, run_json


def test_plot_draws_the_curves_of_the_run(tmp_path: Path) -> None:
    picture = tmp_path / "plot.png"
    status, printed = run_json(SQUARE, "--no-store", "--plot", str(picture))
    assert (status, printed["state"]) == (0, "finished")
    head = picture.read_bytes()[:24]
    assert head[:8] == b"\x89PNG\r\n\x1a\n"
    width, height = (int.from_bytes(head[i : i + 4], "big") for i in (16, 20))
    assert (width, height) == (1320, 1020)


def test_a_plot_that_cannot_be_written_loses_no_run(tmp_path: Path) -> None:
    result = pinel("run", SQUARE, "--json", "--plot", str(tmp_path / "nowhere" / "plot.png"))
    assert result.exit_code == 0
    assert json.loads(result.stdout)["run_id"]
    assert "plot could not be written" in result.stderr


@pytest.mark.parametrize(
    "name", ["plot.docx", "plot.pgf", "plot.eps", "plot", ".png", "plot.png.gz"]
)
def test_a_plot_of_an_unknown_kind_is_refused_before_the_run(name: str, tmp_path: Path) -> None:
    folder = tmp_path / "plots"
    folder.mkdir()
    result = pinel("run", SQUARE, "--json", "--plot", str(folder / name))
    assert result.exit_code == 2
    printed = json.loads(result.stdout)
    assert (printed["reason"], printed["run_id"]) == ("plot_ending", None)
    assert name in printed["message"]
    assert list(folder.iterdir()) == []


def test_without_the_library_it_says_what_to_install_and_runs_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)  # as where it is not installed
    result = pinel("run", SQUARE, "--plot", str(tmp_path / "plot.png"))
    assert result.exit_code == 2
    assert "pinel-desktop[plot]" in result.stdout
    assert list(tmp_path.glob("*.png")) == []


@pytest.mark.parametrize("name", ["a.PNG", "a.svg", "a.Pdf"])
def test_a_plot_is_written_to_the_file_that_was_named(name: str, tmp_path: Path) -> None:
    folder = tmp_path / "plots"
    folder.mkdir()
    program = '{"pinel_ir": 1, "name": "$x_{", "commands": []}'
    status, _ = run_json("-", "--no-store", "--plot", str(folder / name), text=program)
    assert status == 0
    assert [file.name for file in folder.iterdir()] == [name]


def test_plotting_curves_are_those_of_the_telemetry() -> None:
    curves = Curves()
    program = read_document((PROGRAMS / "square.json").read_bytes()).program
    assert program is not None
    link = open_link("sim", world="empty_room")
    result = execute(program, link, RunOptions(observer=curves.observe))
    assert curves["x_m"][1:] == list(result.telemetry.rows[1 :: result.telemetry.COLUMNS])
    assert curves.time_s[-1] == pytest.approx(result.ended.duration_s)
    assert max(curves["goal_x_m"]) == pytest.approx(1.0, abs=1e-6)
