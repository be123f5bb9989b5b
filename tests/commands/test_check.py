"""`pinel check` on the command line."""

import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

from pinel_desktop.activities import Report, check_files
from pinel_desktop.cli import main
from sim.world import world_document

PROGRAMS = Path(__file__).parents[1] / "programs"
SQUARE, TRIANGLE = (str(PROGRAMS / f"{name}.json") for name in ("square", "triangle"))


@pytest.fixture(autouse=True)
def english(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PINEL_LANG", "en")


def check(*arguments: str) -> Result:
    return CliRunner().invoke(main, ["check", *arguments])


def test_a_program_that_fulfils_it_passes() -> None:
    done = check("square", SQUARE)
    assert done.exit_code == 0
    assert done.stdout.splitlines()[-1] == "1/1"


def test_what_does_not_hold_is_said_in_words() -> None:
    done = check("square", TRIANGLE, "--processes", "1")
    assert done.exit_code == 1
    assert "The path is 3 m long; it needs at least 3.95 m." in done.stdout


def test_many_programs_come_in_their_order_whoever_is_first(tmp_path: Path) -> None:
    broken = tmp_path / "broken.json"
    broken.write_text('[{"action": "fly"}]', "utf-8")
    files = [SQUARE, str(broken), TRIANGLE, str(tmp_path / "missing.json"), SQUARE] * 3
    done = check("square", *files, "--json", "--processes", "3")
    reports = [json.loads(line) for line in done.stdout.splitlines()]
    assert [report["program"] for report in reports] == files
    assert [report["passed"] for report in reports] == [True, False, False, False, True] * 3
    assert reports[1]["faults"][0]["code"] == "unknown_action"
    assert reports[3]["faults"][0]["code"] == "file_unreadable"
    hashes = {report["cases"][0]["telemetry_sha256"] for report in reports[::5]}
    assert len(hashes) == 1


def test_an_activity_that_cannot_be_used_ends_with_2(tmp_path: Path) -> None:
    done = check("dance", SQUARE)
    assert done.exit_code == 2
    assert "There is no activity called" in done.stderr
    assert check("square").exit_code == 2


def test_the_world_of_an_activity_may_not_exist(tmp_path: Path) -> None:
    file = tmp_path / "a.json"
    title = {"pt-BR": "x", "en": "x", "es": "x"}
    file.write_text(
        json.dumps(
            {
                "pinel_activity": 1,
                "name": "a",
                "title": title,
                "world": "mars",
                "checks": [{"check": "finished"}],
            }
        ),
        "utf-8",
    )
    for processes in ("1", "2"):
        done = check(str(file), SQUARE, SQUARE, "--processes", processes)
        assert done.exit_code == 2
        assert "mars" in done.stderr


def test_a_world_of_its_own_with_a_fault_is_told_in_words(tmp_path: Path) -> None:
    file = tmp_path / "a.json"
    world = {**world_document("empty_room"), "start": {"x_m": 4.0, "y_m": 0.0, "heading_deg": 0}}
    title = {"pt-BR": "x", "en": "x", "es": "x"}
    checks = [{"check": "finished"}]
    text = {"pinel_activity": 1, "name": "a", "title": title, "world": world, "checks": checks}
    file.write_text(json.dumps(text), "utf-8")
    done = check(str(file), SQUARE)
    assert done.exit_code == 2
    assert "does not fit on the floor" in done.stderr


def test_an_activity_that_nobody_can_fulfil_is_refused_with_all_its_faults(tmp_path: Path) -> None:
    file = tmp_path / "a"  # a file that is there needs no ending
    title = {"pt-BR": "x", "en": "x", "es": "x"}
    checks = [{"check": "ends_in", "zone": "Z"}, {"check": "uses", "action": "fly"}]
    text = {"pinel_activity": 1, "name": "a", "title": title, "world": "pushing", "checks": checks}
    file.write_text(json.dumps(text), "utf-8")
    done = check(str(file), SQUARE)
    assert done.exit_code == 2
    assert "/checks/0/zone: The world of this activity has no place called “Z”." in done.stderr
    assert "/checks/1/action: " in done.stderr


def test_ctrl_c_prints_what_is_ready(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*arguments: Any, **options: Any) -> Iterator[tuple[int, Report]]:
        yield next(check_files(*arguments, **options))
        raise KeyboardInterrupt

    monkeypatch.setattr("pinel_desktop.commands.check.check_files", interrupted)
    done = check("square", SQUARE, TRIANGLE, "--processes", "1")
    assert done.exit_code == 130
    assert done.stdout.splitlines() == [f"+ {SQUARE}", "1/1"]
    assert "Interrupted: 1 of 2" in done.stderr


def test_from_a_shell_with_processes_of_its_own() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "pinel_desktop", "check", "square", SQUARE, TRIANGLE],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert done.returncode == 1
    assert done.stdout.splitlines()[-1] == "1/2"
