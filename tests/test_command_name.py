"""The command that messages and manuals name is one that works in a terminal of this PC."""

import subprocess
import sys
from pathlib import Path

import pytest

from pinel_desktop.command_name import command_name
from pinel_desktop.messages import LANGUAGES, describe


def program_in(folder: Path) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    program = folder / "pinel"
    program.write_text("#!/bin/sh\necho it works\n", "utf-8")
    program.chmod(0o755)
    return program


@pytest.fixture
def packaged(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """The packaged program, in a folder with a space; no `pinel` is on the PATH."""
    program = program_in(tmp_path / "PEN DRIVE" / "PINEL" / "programa")
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    monkeypatch.setattr(sys, "executable", str(program))
    monkeypatch.setenv("PATH", f"{tmp_path / 'bin'}:/bin")
    return program


def test_where_the_package_is_installed_the_command_is_its_name(
    packaged: Path, tmp_path: Path
) -> None:
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "pinel").symlink_to(packaged)
    assert command_name() == "pinel"


def test_the_command_of_the_portable_version_is_a_quoted_path(packaged: Path) -> None:
    assert "PINEL/programa/pinel" in command_name()
    answer = subprocess.run(command_name(), shell=True, capture_output=True, text=True, check=True)
    assert answer.stdout == "it works\n"


def test_another_program_of_that_name_on_the_path_is_not_meant(
    packaged: Path, tmp_path: Path
) -> None:
    program_in(tmp_path / "bin")
    assert "PINEL/programa/pinel" in command_name()


def test_in_a_source_folder_it_is_the_script_of_its_environment(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    python = tmp_path / ".venv" / "bin" / "python"
    monkeypatch.setattr(sys, "executable", str(python))
    assert command_name() == f"{python} -m pinel_desktop"
    script = program_in(python.parent)
    assert command_name() == str(script)
    monkeypatch.setenv("PATH", str(python.parent))
    assert command_name() == "pinel"


@pytest.mark.parametrize("language", LANGUAGES)
def test_messages_name_it(packaged: Path, language: str) -> None:
    line = describe("app_lost", {}, language).line
    assert f"{command_name()} doctor" in line
