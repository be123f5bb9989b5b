"""`pinel update`, with scripts in place of the packaged programs."""

import random
import shutil
import subprocess
import sys
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import psutil
import pytest
from click.testing import CliRunner, Result

from pinel_desktop.cli import main
from pinel_desktop.commands.pc import portable_update, running, update
from storage import open_store
from storage.file.backups import list_backups
from storage.sql import integrity_problem, opened
from tests.attacks.disks import fill, small_disk
from tests.compatibility import archived_files
from tests.packaging.loading import load

portable = load("packaging/portable.py")
pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="portable on Linux only")
Release = Callable[..., Path]
_OLD, _NEW, _OLDER = "0.2.0", "99.1", "0.1.9"
_N_BACKUPS = 3  # of the archived database; more are made only by what is tested here


def write_program(folder: Path, version: str, script: str = "") -> Path:
    """A program that only says its version."""
    (folder / "_internal").mkdir(parents=True)
    (folder / "_internal" / "data").write_text(version, "utf-8")
    program = folder / "pinel"
    program.write_text(f"#!/bin/sh\n{script or f'echo pinel, version {version}'}\n", "utf-8")
    program.chmod(0o755)
    return folder


def said(program: Path) -> str:
    """What the program says of its version, if all its files are of that version."""
    done = subprocess.run(
        [program / "pinel", "--version"], capture_output=True, text=True, check=True
    )
    data = (program / "_internal" / "data").read_text("utf-8")
    assert done.stdout.endswith(f" {data}\n")
    return data


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A portable version with the work of the last release."""
    folder = tmp_path / "PEN DRIVE ção" / "PINEL"
    write_program(folder / "programa", _OLD)
    archived_files.unpack("database", folder / "pinel-data")
    return folder


@pytest.fixture
def release(tmp_path: Path) -> Release:
    """Makes the archive of a release."""

    def make(version: str, script: str = "") -> Path:
        file = tmp_path / f"pinel-desktop-{version}-x86_64.tar.xz"
        portable.write_archive(file, write_program(tmp_path / version, version, script))
        return file

    return make


@pytest.fixture
def run(folder: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[Path], Result]:
    """Runs the command as the program in the folder."""
    monkeypatch.setenv("PINEL_LANG", "en")
    monkeypatch.delenv("PINEL_HOME", raising=False)
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    monkeypatch.setattr(sys, "executable", str(folder / "programa" / "pinel"))
    return lambda file: CliRunner().invoke(main, ["update", str(file)])


@pytest.fixture
def program(folder: Path) -> Path:
    """The program in the folder as a shell, which a test can keep open."""
    return Path(shutil.copy(Path("/bin/sh").resolve(), folder / "programa" / "pinel"))


def last_backup(folder: Path) -> int:
    return list_backups(folder / "pinel-data" / "pinel.db")[0].number


def groups(folder: Path) -> list[str]:
    with open_store(folder / "pinel-data" / "pinel.db") as store:
        return [group.name for group in store.groups.all()]


def test_the_folder_is_replaced_and_the_work_of_the_last_release_opens(
    folder: Path, release: Release, run: Callable[[Path], Result]
) -> None:
    done = run(release(_NEW))
    assert (done.exit_code, said(folder / "programa")) == (0, _NEW), done.output
    assert done.output.startswith("PINEL was updated to version 99.1.")
    assert sorted(path.name for path in folder.iterdir()) == ["pinel-data", "programa"]
    assert last_backup(folder) == _N_BACKUPS + 1
    assert groups(folder)


def test_without_work_there_is_no_backup_and_no_new_file(
    folder: Path, release: Release, run: Callable[[Path], Result]
) -> None:
    shutil.rmtree(folder / "pinel-data")
    (folder / "pinel-data").mkdir()
    assert run(release(_NEW)).exit_code == 0
    assert not list((folder / "pinel-data").glob("pinel.db*"))


def test_the_same_release_repairs_a_program(
    folder: Path, release: Release, run: Callable[[Path], Result]
) -> None:
    (folder / "programa" / "_internal" / "data").write_text("damaged", "utf-8")
    assert run(release(_OLD)).exit_code == 0
    assert said(folder / "programa") == _OLD


def cut(file: Path) -> Path:
    """As a stick that was pulled while it was copied to."""
    file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])
    return file


def flip(file: Path) -> Path:
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.write_bytes(content)
    return file


def rename(file: Path, name: str) -> Path:
    return file.rename(file.with_name(name))


REFUSED: dict[str, tuple[Callable[[Release], Path], str]] = {
    "older": (lambda release: release(_OLDER), "is PINEL 0.1.9, older than this one"),
    "cut off": (lambda release: cut(release(_NEW)), "is damaged or cannot be read to its end"),
    "one bit": (lambda release: flip(release(_NEW)), "is damaged or cannot be read to its end"),
    "does not start": (
        lambda release: release(_NEW, "echo GLIBC_2.99 not found >&2; exit 1"),
        "does not work on this PC (GLIBC_2.99 not found)",
    ),
    "other file": (
        lambda release: rename(release(_NEW), "some.deb"),
        "Use the file pinel-desktop-*-x86_64.tar.xz",
    ),
    "no file": (lambda release: Path("/none.tar.xz"), "There is no file /none.tar.xz."),
}


@pytest.mark.parametrize("which", REFUSED)
def test_what_cannot_be_used_is_refused_in_words_and_changes_nothing(
    which: str, folder: Path, release: Release, run: Callable[[Path], Result]
) -> None:
    make, words = REFUSED[which]
    before = contents(folder)
    done = run(make(release))
    assert done.exit_code == 1
    assert words in done.output
    assert contents(folder) == before


def test_nothing_is_written_beside_the_folder_by_an_archive(
    tmp_path: Path, folder: Path, release: Release, run: Callable[[Path], Result]
) -> None:
    file = release(_NEW)
    for name, kind in (("PINEL/programa/../../../out", b"0"), ("PINEL/programa/link", b"2")):
        with portable.tarfile.open(file, "w:xz") as archive:
            info = portable.tarfile.TarInfo(name)
            info.type, info.linkname = kind, "/etc/passwd"
            archive.addfile(info)
        assert "is damaged" in run(file).output
    assert not (tmp_path / "out").exists()
    assert said(folder / "programa") == _OLD


def test_a_file_system_that_cannot_exchange_folders_is_named(
    folder: Path,
    release: Release,
    run: Callable[[Path], Result],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(portable_update, "_RENAME_EXCHANGE", 1 << 20)  # a flag that no kernel knows
    done = run(release(_NEW))
    assert "cannot be replaced (Invalid argument)" in done.output
    assert said(folder / "programa") == _OLD
    assert not (folder / ".pinel-update").exists()


@pytest.mark.waits
@pytest.mark.parametrize("left_kb", [0, 40, 400])
def test_on_a_full_disk_the_old_program_and_the_work_stay(
    left_kb: int,
    tmp_path: Path,
    folder: Path,
    release: Release,
    run: Callable[[Path], Result],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    file = release(_NEW)
    with small_disk(tmp_path, "tmpfs") as disk:
        (folder / "pinel-data").rename(folder / "other")
        write_program(disk / "PINEL" / "programa", _OLD)
        with open_store(disk / "PINEL" / "pinel-data" / "pinel.db") as store:
            store.groups.create("Onças")
        monkeypatch.setattr(sys, "executable", str(disk / "PINEL" / "programa" / "pinel"))
        fill(disk, left_kb)
        done = run(file)
        assert done.exit_code == 1
        assert "room" in done.output, done.output
        assert said(disk / "PINEL" / "programa") == _OLD
        assert not (disk / "PINEL" / ".pinel-update").exists()
        (disk / "film.mp4").unlink()
        assert groups(disk / "PINEL") == ["Onças"]


@pytest.mark.waits
@pytest.mark.parametrize("script", ["read line", "trap '' TERM; read line"])
def test_an_open_program_is_closed_in_words_also_one_that_does_not_listen(
    script: str,
    folder: Path,
    program: Path,
    release: Release,
    run: Callable[[Path], Result],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(running, "_CLOSING_S", 2)
    with subprocess.Popen([program, "-c", f"{script}; :"], stdin=subprocess.PIPE) as process:
        done = run(release(_NEW))
        assert process.poll() is not None
    assert "PINEL is open and will be closed" in done.output
    assert said(folder / "programa") == _NEW


@pytest.mark.waits
def test_a_process_that_becomes_the_program_is_found(program: Path) -> None:
    script = f"read line; exec '{program}' -c 'read line; :'"
    with subprocess.Popen(["sh", "-c", script], stdin=subprocess.PIPE) as process:
        assert running.running(program) == []
        assert process.stdin is not None
        process.stdin.write(b"\n")
        process.stdin.flush()
        while psutil.Process(process.pid).exe() != str(program):
            assert process.poll() is None
        assert [one.pid for one in running.running(program)] == [process.pid]
        process.kill()


@pytest.mark.waits
def test_an_ended_program_is_not_open_although_its_parent_has_not_read_its_end(
    folder: Path,
    program: Path,
    release: Release,
    run: Callable[[Path], Result],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(running, "_CLOSING_S", 2)
    script = f"'{program}' -c 'while :; do sleep 0.1; done' & exec sleep 100"
    with subprocess.Popen(["sh", "-c", script]) as parent:
        while not running.running(program):
            assert parent.poll() is None
        done = run(release(_NEW))
        parent.kill()
    assert (done.exit_code, said(folder / "programa")) == (0, _NEW), done.output


@pytest.mark.waits
def test_a_program_that_another_account_has_open_is_named(
    folder: Path,
    program: Path,
    release: Release,
    run: Callable[[Path], Result],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(running, "_CLOSING_S", 0.1)
    monkeypatch.setattr(running, "_ask", lambda end: None)  # as without the right to end it
    with subprocess.Popen([program, "-c", "read line; :"], stdin=subprocess.PIPE) as process:
        done = run(release(_NEW))
        assert f"still open, perhaps in another account (process {process.pid})" in done.output
        assert process.poll() is None
        process.kill()
    assert not (folder / ".pinel-update").exists()


@pytest.mark.parametrize("version", ["0.0.1", "99"])
def test_a_package_for_debian_is_checked_and_its_command_is_printed(
    version: str,
    tmp_path: Path,
    folder: Path,
    run: Callable[[Path], Result],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(update, "_DEBIAN_FOLDER", folder / "programa")
    monkeypatch.setenv("PINEL_HOME", str(folder / "pinel-data"))
    file = package(tmp_path / "PEN DRIVE", version)
    done = run(file)
    n_backups = last_backup(folder)
    if version == "99":
        assert f"To update, type: sudo apt install '{file}'" in done.output
        assert (done.exit_code, n_backups) == (0, _N_BACKUPS + 1)
        assert "is damaged" in run(cut(file)).output
    else:
        assert "is PINEL 0.0.1, older than this one" in done.output
        assert (done.exit_code, n_backups) == (1, _N_BACKUPS)


def package(folder: Path, version: str) -> Path:
    """A package for Debian with a file in it."""
    control = folder / "root" / "DEBIAN" / "control"
    control.parent.mkdir(parents=True)
    fields = f"Package: pinel-desktop\nVersion: {version}\nArchitecture: all\n"
    control.write_text(f"{fields}Maintainer: PINEL <p@localhost>\nDescription: test\n", "utf-8")
    (folder / "root" / "data").write_bytes(random.Random(1).randbytes(100_000))
    file = folder / f"pinel-desktop_{version}_amd64.deb"
    command = ["dpkg-deb", "--build", str(folder / "root"), str(file)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return file


def test_on_windows_the_installer_is_named_after_a_backup(
    tmp_path: Path,
    folder: Path,
    run: Callable[[Path], Result],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(update, "_kind_of_installation", lambda: "-setup.exe")
    for version, status in (("99", 0), ("0.1", 1)):
        file = tmp_path / f"pinel-desktop-{version}-setup.exe"
        file.touch()
        done = run(file)
        assert done.exit_code == status
        assert (f'start /wait "" {file}' in done.output) is not status
    assert last_backup(folder) == _N_BACKUPS + 1


def test_a_source_folder_is_not_replaced(
    release: Release, run: Callable[[Path], Result], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delattr(sys, "frozen")
    assert "This PINEL is a source folder." in run(release(_NEW)).output


def rows(folder: Path) -> list[object]:
    """Keys of the work, of a file that is intact."""
    with closing(opened(folder / "pinel-data" / "pinel.db", "rw")) as db:
        assert integrity_problem(db) is None
        return [tuple(row) for row in db.execute("SELECT id, program_id FROM versions ORDER BY id")]


def contents(folder: Path) -> dict[Path, bytes]:
    return {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.mark.waits
def test_a_kill_at_any_step_leaves_one_of_the_two_programs_and_the_work(
    tmp_path: Path, folder: Path, release: Release, monkeypatch: pytest.MonkeyPatch
) -> None:
    script = Path(__file__).with_name("killed_update.py")
    copies, exchanged = tmp_path / "copies", tmp_path / "exchanged"
    copies.mkdir()
    exchanged.mkdir()
    monkeypatch.delenv("PINEL_HOME", raising=False)
    file = release(_NEW)
    command = [sys.executable, str(script), *map(str, (folder, file, copies, exchanged))]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    work = rows(folder)
    versions = []
    for copy in sorted(copies.iterdir(), key=lambda path: int(path.name)):
        versions.append(said(copy / "programa"))
        assert versions[-1] == (_NEW if (exchanged / copy.name).exists() else _OLD)
        assert rows(copy) == work
    assert versions.count(_OLD) > 30
    assert versions.count(_NEW) > 3
    assert versions[-1] == _NEW
    last = copies / str(len(versions))
    assert not (last / ".pinel-update").exists()
    assert groups(last)
