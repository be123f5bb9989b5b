"""Disks that are small, full or read-only, and an app of its own process on them."""

import os
import re
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import pytest

from tests.web.browser import Browser

_IS_ROOT = hasattr(os, "geteuid") and os.geteuid() == 0
_END_S = 60.0
_LEFT_BY_A_KILL = """
import os, sys
from pathlib import Path
from storage import open_store
open_store(Path(sys.argv[1])).groups.create("Onças")
os._exit(0)
"""


@contextmanager
def small_disk(folder: Path, kind: str) -> Iterator[Path]:
    """A file system of its own, of the kind `tmpfs` or `ext4`; skips where this user may make none."""
    disk = folder / "disk"
    disk.mkdir()
    if not _IS_ROOT or not _is_mounted(disk, kind):
        pytest.skip("only root can make a small disk")
    try:
        yield disk
    finally:
        subprocess.run(["umount", "-l", str(disk)], check=True)


def _is_mounted(disk: Path, kind: str) -> bool:
    if kind == "tmpfs":
        return _runs("mount", "-t", "tmpfs", "-o", "size=4000k", "tmpfs", disk)
    image = disk.with_name("disk.img")
    with image.open("wb") as file:
        file.truncate(8 << 20)
    made = _runs("mkfs.ext4", "-q", "-b", "4096", "-m", "0", image)
    return made and _runs("mount", "-o", "loop", image, disk)


def _runs(*command: str | Path) -> bool:
    with suppress(FileNotFoundError):
        return subprocess.run(command, capture_output=True, check=False).returncode == 0
    return False


def make_read_only(disk: Path) -> None:
    """As the system does it to a disk with errors (ext4, errors=remount-ro)."""
    subprocess.run(["mount", "-o", "remount,abort", str(disk)], check=True)


def fill(disk: Path, left_kb: int) -> None:
    """Leaves that much room, to a page."""
    film = disk / "film.mp4"
    with suppress(OSError), film.open("wb", buffering=0) as file:
        while True:
            file.write(bytes(1024))
    os.sync()
    os.truncate(film, film.stat().st_size - max(0, left_kb * 1024 - _free(disk)))
    os.sync()
    assert _free(disk) == left_kb * 1024


def _free(disk: Path) -> int:
    found = os.statvfs(disk)
    return found.f_bavail * found.f_frsize


def left_by_a_kill(path: Path) -> None:
    """A file with one group, which is in its log only."""
    subprocess.run([sys.executable, "-c", _LEFT_BY_A_KILL, str(path)], check=True)


class Served:
    """`pinel serve`, and a browser that has opened its page."""

    def __init__(self, database: Path, *options: str) -> None:
        self.path = database
        self._output = tempfile.TemporaryFile("w+", encoding="utf-8")  # noqa: SIM115 - closed with the app
        self._process = subprocess.Popen(
            [*_PINEL, "--db", str(database), "serve", *options],
            stdout=subprocess.PIPE,
            stderr=self._output,
            text=True,
            env=os.environ | {"PINEL_LANG": "en"},
        )
        assert self._process.stdout is not None
        address = self._process.stdout.readline().strip()
        assert re.match(r"http://127\.0\.0\.1:\d+/", address), self.output
        self.browser = Browser.signed_in(address)

    @property
    def output(self) -> str:
        """What it said to people."""
        self._output.seek(0)
        return self._output.read()

    @property
    def database(self) -> Any:
        """What it says of its file."""
        return self.browser.get("/api/status").data["database"]

    @property
    def groups(self) -> list[str]:
        return [group["name"] for group in self.browser.get("/api/groups").data["groups"]]

    def end(self) -> int:
        """Ends it as Ctrl+C does; returns its status."""
        self._process.send_signal(signal.SIGINT)
        return self._process.wait(_END_S)

    def close(self) -> None:
        self._process.kill()
        self._process.communicate()
        self._output.close()


_PINEL = (sys.executable, "-m", "pinel_desktop")


@contextmanager
def served(database: Path, *options: str) -> Iterator[Served]:
    app = Served(database, *options)
    try:
        yield app
    finally:
        app.close()


def second_start(database: Path) -> tuple[int, str]:
    """Status and words of `pinel serve` while the file is open already."""
    done = subprocess.run(
        [*_PINEL, "--db", str(database), "serve"],
        capture_output=True,
        text=True,
        check=False,
        timeout=100,
        env=os.environ | {"PINEL_LANG": "en"},
    )
    return done.returncode, done.stderr
