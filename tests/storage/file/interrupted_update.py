"""Opens files as the first start after an update does, and kills itself in the middle; test_update.py looks at them.

The parent reads lines `{"path": ..., "n_steps": ...}` and forks a child for each. The child kills itself after so many
calls that change the disk or the database; without `n_steps` it opens and closes the file. The parent prints
`{"killed": ..., "n_steps": ...}`.
"""

import json
import os
import signal
import sys
from pathlib import Path
from types import FrameType
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[3]))

import sqlite_utils  # noqa: F401 - what is imported once need not be by each child

from storage import open_store, warm_up
from storage.sqlite import sqlite3
from storage.tables.ddl import MIGRATIONS

# of a release to come
NEXT_MIGRATIONS = {
    "mottos": (
        "ALTER TABLE groups ADD COLUMN motto TEXT NOT NULL DEFAULT ''",
        "UPDATE groups SET motto = name",
    ),
    "next_table": ("CREATE TABLE next_table (id TEXT PRIMARY KEY) STRICT",),
    "next_index": ("CREATE INDEX next_index ON groups (motto)",),
}
_OF_SYSTEM = (os.open, os.mkdir, os.rename, os.replace, os.unlink, os.fsync, os.close, os.chmod)


class Killer:
    """Counts the calls that change something, and kills the process after one of them."""

    def __init__(self, n_steps: int | None) -> None:
        self.n_steps, self._last = 0, n_steps

    def __call__(self, frame: FrameType, event: str, called: Any) -> None:
        owner = getattr(called, "__self__", None)
        is_step = called in _OF_SYSTEM or isinstance(owner, sqlite3.Connection | sqlite3.Cursor)
        if event != "c_return" or not is_step:
            return
        self.n_steps += 1
        if self.n_steps == self._last:
            os.kill(os.getpid(), signal.SIGKILL)


def start(path: Path, n_steps: int | None) -> int:
    """Opens and closes the file; returns the number of steps."""
    MIGRATIONS.update(NEXT_MIGRATIONS)
    killer = Killer(n_steps)
    sys.setprofile(killer)
    open_store(path).close()
    sys.setprofile(None)
    return killer.n_steps


def main() -> None:
    warm_up()
    for line in sys.stdin:
        order = json.loads(line)
        reading, writing = os.pipe()
        child = os.fork()
        if not child:
            os.write(writing, str(start(Path(order["path"]), order.get("n_steps"))).encode())
            os._exit(0)
        os.close(writing)
        with os.fdopen(reading, "rb") as pipe:
            n_steps = pipe.read()
        _, status = os.waitpid(child, 0)
        outcome = {"killed": os.WIFSIGNALED(status), "n_steps": int(n_steps or 0)}
        print(json.dumps(outcome), flush=True)


if __name__ == "__main__":
    main()
