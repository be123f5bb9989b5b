"""Runs `pinel update` as a portable program does, and kills it in the middle; test_update.py looks at the folders.

    python killed_update.py FOLDER ARCHIVE COPIES EXCHANGED

FOLDER is a portable version. Each update is a child with a copy of it, COPIES/1, COPIES/2, …, which kills itself after
one, two, … calls that change the disk. The last one is not killed. EXCHANGED/380 is an empty file if update 380 has
exchanged the folders: on a busy PC an update waits longer and makes more calls before that.
"""

import os
import shutil
import signal
import sys
from pathlib import Path
from types import FrameType
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[2]))

from pinel_desktop.cli import main
from pinel_desktop.commands.pc import portable_update
from pinel_desktop.commands.pc import update as _  # noqa: F401 - imported once, not by each child
from storage import warm_up

_EXCHANGE = portable_update.exchange.__code__
_OF_SYSTEM = (
    *(open, os.open, os.close, os.fsync, os.sync, os.rename, os.replace, os.link),
    *(os.mkdir, os.rmdir, os.unlink, os.chmod, os.utime),
)


class Killer:
    """Counts the calls that change something, and kills the process after one of them."""

    def __init__(self, n_steps: int, exchanged: Path) -> None:
        self._left, self._exchanged = n_steps, exchanged

    def __call__(self, frame: FrameType, event: str, called: Any) -> None:
        is_exchange = event == "return" and frame.f_code is _EXCHANGE
        if is_exchange:
            self._exchanged.touch()
        if is_exchange or (event == "c_return" and called in _OF_SYSTEM):
            self._left -= 1
            if not self._left:
                os.kill(os.getpid(), signal.SIGKILL)


def update(folder: Path, archive: str, killer: Killer) -> None:
    """Plays the program of a portable version that is updated."""
    sys.frozen = True  # type: ignore[attr-defined]
    sys.executable = str(folder / "programa" / "pinel")
    sys.setprofile(killer)
    try:
        main(["update", archive])
    finally:
        sys.setprofile(None)


def is_killed(folder: Path, archive: str, killer: Killer) -> bool:
    """Updates in a child that the killer may kill; returns False if it ends before."""
    child = os.fork()
    if not child:
        update(folder, archive, killer)
    return os.WIFSIGNALED(os.waitpid(child, 0)[1])


def kill_at_each_step(folder: Path, archive: str, copies: Path, exchanged: Path) -> None:
    warm_up()
    n_steps = 0
    while True:
        n_steps += 1
        copy = copies / str(n_steps)
        shutil.copytree(folder, copy)
        if not is_killed(copy, archive, Killer(n_steps, exchanged / copy.name)):
            return


if __name__ == "__main__":
    kill_at_each_step(Path(sys.argv[1]), sys.argv[2], Path(sys.argv[3]), Path(sys.argv[4]))
