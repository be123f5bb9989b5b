"""Replaces the folder of the portable program by that of a newer release, in one step.

The new folder is complete, tried and on the disk before the two folders exchange their names (`renameat2` of Linux). So
a kill or a power cut at any moment leaves the old program or the new one, and the work beside it as it was.
"""

import ctypes
import lzma
import os
import re
import shutil
import subprocess
import sys
import tarfile
from collections.abc import Iterator
from pathlib import Path

from pinel_desktop.errors import PinelError
from storage.errors import is_full

# of packaging/portable.py
_FOLDER = "PINEL/programa"
_STAGING = ".pinel-update"
_VERSION = re.compile(r"version (\d+(?:\.\d+)*)")
_TRIAL_TIMEOUT_S = 120
_AT_FDCWD, _RENAME_EXCHANGE = -100, 2


def _staging_folder(program: Path) -> Path:
    """Returns the folder beside the program's that holds the new one before the exchange, the old one after it."""
    return program.parent / _STAGING


def unpack(archive: Path, program: Path) -> Path:
    """Unpacks the program of an archive beside the program's folder; returns the new folder.

    Raises:
        PinelError: `update_damaged`, `update_no_room`, `update_not_replaceable`; nothing is left then.
    """
    staging = _staging_folder(program)
    try:
        discard(program)  # left by a power cut
        staging.mkdir()
    except OSError as error:
        raise _not_replaceable(program, error) from error
    new = staging / _FOLDER
    try:
        with tarfile.open(archive, "r:xz") as content:
            content.extractall(staging, _members(content))
        if not (new / "pinel").is_file():
            raise tarfile.ReadError
    except (tarfile.TarError, lzma.LZMAError, EOFError, OSError) as error:
        discard(program)
        if isinstance(error, OSError) and is_full(error):
            raise PinelError("update_no_room", folder=str(program.parent)) from error
        raise PinelError("update_damaged", path=str(archive)) from error
    return new


def version_of(new: Path) -> str:
    """Starts the new program and returns its version. Raises PinelError `update_does_not_start`."""
    try:
        done = subprocess.run(
            [new / "pinel", "--version"],
            env=os.environ | {"PYINSTALLER_RESET_ENVIRONMENT": "1"},
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=_TRIAL_TIMEOUT_S,
            check=False,
        )
    except (OSError, subprocess.SubprocessError) as error:
        raise PinelError("update_does_not_start", problem=str(error)) from error
    version = _VERSION.search(done.stdout)
    if done.returncode or not version:
        problem = (done.stderr.strip().splitlines() or [f"status {done.returncode}"])[-1]
        raise PinelError("update_does_not_start", problem=problem)
    return version[1]


def exchange(program: Path, new: Path) -> None:
    """Exchanges the names of two folders in one step.

    Raises:
        PinelError: `update_not_replaceable`, as on file systems that cannot; nothing has changed.
    """
    if sys.platform != "win32":
        os.sync()  # otherwise a power cut could leave files without content under the new name
    paths = (_AT_FDCWD, os.fsencode(program), _AT_FDCWD, os.fsencode(new))
    libc = ctypes.CDLL(None, use_errno=True)
    if libc.renameat2(*paths, _RENAME_EXCHANGE):
        number = ctypes.get_errno()
        raise _not_replaceable(program, OSError(number, os.strerror(number)))


def discard(program: Path) -> None:
    """Deletes the folder that is not in use: the new one before the exchange, the old one after it."""
    shutil.rmtree(_staging_folder(program), ignore_errors=True)


def _members(content: tarfile.TarFile) -> Iterator[tarfile.TarInfo]:
    """Yields the program's files and folders. Raises TarError for anything that would be written elsewhere."""
    for member in content:
        if not member.name.startswith(f"{_FOLDER}/"):
            continue
        if ".." in member.name.split("/") or not (member.isreg() or member.isdir()):
            raise tarfile.ReadError(member.name)
        yield member


def _not_replaceable(program: Path, error: OSError) -> PinelError:
    if is_full(error):
        return PinelError("update_no_room", folder=str(program.parent))
    return PinelError("update_not_replaceable", folder=str(program), problem=error.strerror)
