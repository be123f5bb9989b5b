"""An export that is killed: at each step that it does in the folder, and at moments of chance."""

import subprocess
import sys
from contextlib import closing
from pathlib import Path

from storage.sql import integrity_problem, opened, row_count

# forks for each export, as loading the store takes longer than all of them; prints how many steps an export has
_KILLED = """
import os, random, signal, sys, time
from pathlib import Path
from storage import open_for_reading

store, folder, n_by_chance = Path(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3])
chance = random.Random(24)

def export(name="PC"):
    with open_for_reading(store) as opened:
        opened.exchange.export(
            folder / f"{name}.pinel", app_version="1", computer=("1" * 36, "PC"), is_recorded=False
        )

def killed_at(n_steps):
    left = n_steps
    def step(name, arguments):
        nonlocal left
        if not name.startswith(("open", "os.")) or str(folder) not in str(arguments):
            return
        left -= 1
        if left < 0:
            os.kill(os.getpid(), signal.SIGKILL)
    sys.addaudithook(step)
    export(f"PC {n_steps}")  # a name that is taken takes more steps

def in_child(work):
    pid = os.fork()
    if pid == 0:
        try:
            work()
        finally:
            os._exit(0)
    return pid

def was_killed(pid):
    return os.WIFSIGNALED(os.waitpid(pid, 0)[1])

export()  # loads all that it needs
began = time.monotonic()
assert not was_killed(in_child(export))
takes_s = time.monotonic() - began
n_steps = 0
while was_killed(in_child(lambda: killed_at(n_steps))):
    n_steps += 1
for _ in range(n_by_chance):
    pid = in_child(export)
    time.sleep(chance.uniform(0, takes_s))
    os.kill(pid, signal.SIGKILL)
    os.waitpid(pid, 0)
print(n_steps)
"""


def killed_exports(store: Path, folder: Path, *, n_by_chance: int) -> int:
    """Exports into a folder again and again, each time killed; returns at how many steps."""
    done = subprocess.run(
        [sys.executable, "-c", _KILLED, str(store), str(folder), str(n_by_chance)],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return int(done.stdout)


def is_whole(bundle: Path) -> bool:
    """A bundle with its own row and no damage."""
    if not bundle.stat().st_size:
        return False
    with closing(opened(bundle, "immutable")) as db:
        return integrity_problem(db) is None and row_count(db, "bundle") == 1
