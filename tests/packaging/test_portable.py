"""The portable version, made of a small folder in place of the program; and its folder for the work of the groups."""

import sys
import tarfile
from pathlib import Path

import pytest

from pinel_desktop.database_locations import is_location_missing, record_location
from pinel_desktop.paths import DATABASE_NAME, database_path
from tests.packaging.loading import load

portable = load("packaging/portable.py")


def test_the_archive_has_the_program_and_a_folder_for_the_work(tmp_path: Path) -> None:
    package = tmp_path / "package"
    package.mkdir()
    (package / "pinel").write_bytes(b"program")
    (package / "pinel").chmod(0o755)
    for name in ("one.tar.xz", "again.tar.xz"):
        portable.write_archive(tmp_path / name, package)
    assert (tmp_path / "one.tar.xz").read_bytes() == (tmp_path / "again.tar.xz").read_bytes()
    with tarfile.open(tmp_path / "one.tar.xz") as archive:
        modes = {one.name: (one.isdir(), one.mode, one.uid) for one in archive.getmembers()}
    assert modes == {
        "PINEL": (True, 0o755, 0),
        "PINEL/pinel-data": (True, 0o755, 0),
        "PINEL/LEIA-ME.txt": (False, 0o644, 0),
        "PINEL/programa/pinel": (False, 0o755, 0),
    }


@pytest.fixture
def stick(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A stick with the packaged program, which is this process."""
    program = tmp_path / "PEN DRIVE" / "PINEL" / "programa" / "pinel"
    program.parent.mkdir(parents=True)
    program.touch()
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    monkeypatch.setattr(sys, "executable", str(program))
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "home"))
    monkeypatch.delenv("PINEL_HOME", raising=False)
    return program.parents[1]


def test_work_lies_beside_the_program_while_its_folder_is_there(
    stick: Path, tmp_path: Path
) -> None:
    assert database_path() == tmp_path / "home" / "pinel" / DATABASE_NAME
    (stick / "pinel-data").mkdir()
    assert database_path() == stick / "pinel-data" / DATABASE_NAME


def test_a_folder_that_somebody_chose_comes_first(
    stick: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (stick / "pinel-data").mkdir()
    monkeypatch.setenv("PINEL_HOME", str(tmp_path / "chosen"))
    assert database_path() == tmp_path / "chosen" / DATABASE_NAME


def test_the_portable_program_writes_nothing_into_the_home_folder(
    stick: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(
        "TMPDIR", str(tmp_path / "other")
    )  # places in temporary folders are never recorded
    monkeypatch.setattr("tempfile.tempdir", None)
    (stick / "pinel-data").mkdir()
    record_location(database_path())
    assert not (tmp_path / "home").exists()
    assert not is_location_missing(database_path())
