"""The report of `pinel doctor` for support, and what the doctor says of the PC's set-up file."""

import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from pinel_desktop.cli import main
from pinel_desktop.commands.pc import first_start
from pinel_desktop.doctor.examination import HealthCheckResult
from storage import open_store


def diagnosis(*arguments: str) -> Result:
    return CliRunner().invoke(main, ["doctor", *arguments])


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """The doctor without window, engine and camera."""
    version = HealthCheckResult("program", "ok", "doctor_page_ok")
    monkeypatch.setattr("pinel_desktop.commands.doctor.examine", lambda database: iter([version]))


def test_a_report_has_neither_work_nor_names(
    tmp_path: Path, quick: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    home = tmp_path / "maria.souza"
    home.mkdir()
    monkeypatch.setattr(Path, "home", lambda: home)
    database, file = home / "pinel.db", tmp_path / "report.json"
    with open_store(database) as store:
        classroom = store.classrooms.create("Turma da Ana")
        group = store.groups.create("Os Tatus", classroom_id=classroom.id)
        store.programs.create(group.id, "Nosso segredo")
    done = diagnosis("--report", str(file), "--db", str(database))
    assert done.exit_code == 0, done.output
    text = file.read_text("utf-8")
    report = json.loads(text)
    assert report["rows"]["groups"] == 1
    assert report["machine"]["memory_mb"] > 100
    assert [one["code"] for one in report["findings"]] == ["doctor_page_ok"]
    assert "pinel.db" in [one["name"] for one in report["files"]]
    for secret in ("Ana", "Tatus", "segredo", "maria", group.id):
        assert secret not in text


def test_a_report_is_written_of_a_pc_without_a_readable_database(
    tmp_path: Path, quick: None
) -> None:
    database, file = tmp_path / "pinel.db", tmp_path / "report.json"
    database.write_bytes(b"no database" * 1000)
    assert diagnosis("--report", str(file), "--db", str(database)).exit_code == 0
    assert json.loads(file.read_text("utf-8"))["rows"] == {}


def test_a_report_that_cannot_be_written_is_an_error(tmp_path: Path, quick: None) -> None:
    done = diagnosis("--report", str(tmp_path / "away" / "report.json"))
    assert done.exit_code == 1
    assert "away" in done.stderr


@pytest.mark.parametrize(
    ("text", "expected"),
    [("camera = 0", ("ok", "doctor_setup_ok")), ("level = 9", ("warn", "pc_setup_value"))],
)
def test_the_set_up_file_of_the_pc_is_checked(
    text: str,
    expected: tuple[str, str],
    tmp_path: Path,
    quick: None,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    file = tmp_path / "pinel.toml"
    file.write_text(text, "utf-8")
    monkeypatch.setattr(first_start, "SETUP_FILE", file)
    findings = json.loads(diagnosis("--json").stdout)["findings"]
    assert expected in [(one["level"], one["code"]) for one in findings]
