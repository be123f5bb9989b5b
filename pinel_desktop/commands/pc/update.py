"""`pinel update`: brings this PC to a newer release by a file, such as from a stick."""

import re
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path

import click

import storage.file.open_files  # noqa: F401 - releasing the lock imports it, and after the exchange nothing may be imported
from pinel_desktop import __version__
from pinel_desktop.command_name import quoted
from pinel_desktop.commands.options import chosen_database, database_option
from pinel_desktop.commands.pc import portable_update, running
from pinel_desktop.commands.printing import Failure
from pinel_desktop.errors import PinelError
from pinel_desktop.instance import InstanceLock
from pinel_desktop.messages import describe, language_of_system
from storage import StoreError
from storage.file.backups import make_backup

# what each kind of installation is updated by, and the command that does it where PINEL itself cannot
_PORTABLE, _DEBIAN, _WINDOWS = ".tar.xz", ".deb", "-setup.exe"
_FILES = {
    _PORTABLE: "pinel-desktop-*-x86_64.tar.xz",
    _DEBIAN: "pinel-desktop_*_amd64.deb",
    _WINDOWS: "pinel-desktop-*-setup.exe",
}
_COMMANDS = {_DEBIAN: "sudo apt install", _WINDOWS: 'start /wait ""'}
_DEBIAN_FOLDER = Path("/usr/lib/pinel-desktop")


@click.command()
@click.argument("file", type=click.Path(path_type=Path))
@database_option
@click.pass_context
def command(ctx: click.Context, file: Path) -> None:
    """Update this PINEL by FILE, a newer release (docs/install.md).

    Makes a backup of the work first. The portable version is closed if it is open, and replaced in one step. Where an
    installer put PINEL, only checks FILE and prints the command that installs it. Refuses an older release.
    Exit status: 0, or 1 if nothing was changed.
    """
    try:
        kind = _kind_of_installation()
        if not file.name.endswith(kind):
            raise PinelError("update_other_file", path=str(file), expected=_FILES[kind])
        if not file.is_file():
            raise PinelError("update_missing", path=str(file))
        if kind == _PORTABLE:
            _update_portable(file, chosen_database(ctx))
        else:
            _prepare(file, kind, chosen_database(ctx))
    except (PinelError, StoreError) as error:
        raise Failure(error) from error


def _kind_of_installation(platform: str = sys.platform) -> str:
    """Returns the end of the name of the files that update this PINEL. Raises PinelError `update_source`."""
    if not getattr(sys, "frozen", False):
        raise PinelError("update_source")
    if platform == "win32":
        return _WINDOWS
    return _DEBIAN if _program_folder() == _DEBIAN_FOLDER else _PORTABLE


def _program_folder() -> Path:
    return Path(sys.executable).resolve().parent


def _update_portable(file: Path, database: Path) -> None:
    program = _program_folder()
    new = portable_update.unpack(file, program)
    try:
        version = portable_update.version_of(new)
        _require_not_older(file, version)
        done = _text("update_done", version=version)
        _close(program / "pinel")
        with _locked(database):
            _back_up(database)
            portable_update.exchange(program, new)
    finally:
        portable_update.discard(program)
    click.echo(done)


@contextmanager
def _locked(database: Path) -> Iterator[None]:
    """Keeps PINEL from being opened meanwhile."""
    lock = InstanceLock(database)
    lock.acquire()
    try:
        yield
    finally:
        lock.release()


def _prepare(file: Path, kind: str, database: Path) -> None:
    """Checks the file of an installer, makes a backup, and prints the command."""
    if kind == _DEBIAN:
        _require_not_older(file, _version_of_package(file))
    elif found := re.search(r"-(\d+(?:\.\d+)*)-setup\.exe$", file.name):
        _require_not_older(file, found[1])  # the installer itself refuses too
    _back_up(database)
    path = quoted(str(file.resolve()))
    click.echo(_text("update_by_installer", program=_COMMANDS[kind], file=path))


def _version_of_package(file: Path) -> str:
    """Returns the version of a package for Debian. Raises PinelError `update_damaged`."""
    try:
        subprocess.run(["dpkg-deb", "--contents", file], capture_output=True, check=True)
        question = ["dpkg-deb", "--field", str(file), "Version"]
        done = subprocess.run(question, capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError) as error:
        raise PinelError("update_damaged", path=str(file)) from error
    return done.stdout.strip()


def _require_not_older(file: Path, version: str) -> None:
    """Refuses an older release. The same release is allowed: it mends a damaged program."""
    if _numbers(version) < _numbers(__version__):
        raise PinelError("update_older", path=str(file), version=version, current=__version__)


def _numbers(version: str) -> list[int]:
    return [int(number) for number in re.findall(r"\d+", version)]


def _close(program: Path) -> None:
    """Closes open PINELs of this folder, in words."""
    if not (processes := running.running(program)):
        return
    click.echo(_text("update_closing"))
    if left := running.close(processes):
        raise PinelError("update_still_open", pid=left[0].pid)


def _back_up(database: Path) -> None:
    if database.is_file():
        make_backup(database, datetime.now(UTC))


def _text(code: str, **params: object) -> str:
    return describe(code, params, language_of_system()).line
