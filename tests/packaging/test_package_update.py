"""`pinel update` of the real portable version: this release over a copy of its package, with older work."""

import random
import re
import shutil
import signal
import subprocess
import threading
import time
from pathlib import Path

import pytest

from tests.compatibility import archived_files
from tests.packaging.loading import ROOT, load
from tests.web.browser import Browser

pytestmark = [pytest.mark.packaged, pytest.mark.nightly]
portable = load("packaging/portable.py")
_PACKAGE = ROOT / "dist" / "pinel-desktop"
_TIMEOUT_S = 180


class Stick:
    """A portable version with the work of release 0.2."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder / "PEN DRIVE ção" / "PINEL"
        self.program = self.folder / "programa" / "pinel"
        shutil.copytree(_PACKAGE, self.program.parent)
        archived_files.unpack("database", self.folder / "pinel-data")
        self._home = folder / "home"
        self._home.mkdir()

    def start(self, *arguments: str | Path) -> "subprocess.Popen[str]":
        return subprocess.Popen(
            [self.program, *arguments],
            env={"HOME": str(self._home), "LANG": "en_US.UTF-8"},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )

    def update(self) -> "subprocess.Popen[str]":
        assert portable.portable_path().is_file(), "there is no archive: make portable"
        return self.start("update", portable.portable_path())

    def groups(self) -> list[str]:
        """What a browser sees of the work."""
        with self.start("serve") as app:
            assert app.stdout is not None
            found = None
            while not (found := re.match(r"http://127\S+", app.stdout.readline())):
                assert app.poll() is None
            browser = Browser.signed_in(found[0])
            groups = [group["name"] for group in browser.get("/api/groups").data["groups"]]
            app.send_signal(signal.SIGINT)
            app.stdout.read()
        return groups

    @property
    def names(self) -> list[str]:
        return sorted(path.name for path in self.folder.iterdir())


@pytest.fixture
def stick(tmp_path: Path) -> Stick:
    return Stick(tmp_path)


def test_the_open_program_is_closed_and_replaced_and_older_work_opens(stick: Stick) -> None:
    before = stick.program.stat().st_ino
    with stick.start("serve") as opened:
        assert opened.stdout is not None
        assert opened.stdout.readline()
        threading.Thread(target=opened.wait).start()
        with stick.update() as update:
            said, _ = update.communicate(timeout=_TIMEOUT_S)
        assert update.returncode == 0, said
        assert "PINEL is open and will be closed" in said
        assert "PINEL was updated to version" in said
        assert "Traceback" not in said
        assert opened.wait(_TIMEOUT_S) in (0, -signal.SIGTERM)
    assert stick.program.stat().st_ino != before
    assert stick.names == ["pinel-data", "programa"]
    assert stick.groups()
    assert not list((stick.folder.parents[1] / "home").rglob("*.db"))


def test_killed_updates_leave_a_program_that_starts_and_the_work(stick: Stick) -> None:
    chance = random.Random(27)
    with stick.start("serve") as first:  # migrated, as by the first start of a release
        first.send_signal(signal.SIGINT)
        first.communicate(timeout=_TIMEOUT_S)
    groups = stick.groups()
    started_s = time.monotonic()
    with stick.update() as update:
        update.communicate(timeout=_TIMEOUT_S)
    duration_s = time.monotonic() - started_s
    for _ in range(5):
        with stick.update() as update:
            time.sleep(chance.uniform(0.5, 1) * duration_s)
            update.kill()
        with stick.start("--version") as program:
            assert "version" in program.communicate(timeout=_TIMEOUT_S)[0]
    assert stick.groups() == groups
    with stick.update() as update:
        update.communicate(timeout=_TIMEOUT_S)
    assert stick.names == ["pinel-data", "programa"]
