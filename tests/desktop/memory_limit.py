"""A control group with a memory limit, for processes that a test starts. It needs Linux and root."""

import contextlib
import os
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

import pytest

_MOUNT = Path("/sys/fs/cgroup")
_JOIN = 'echo $$ > "$0/cgroup.procs" && exec "$@"'
_WITHIN_S = 20.0


class MemoryGroup:
    """A control group; `folder` is its folder, `is_unified` says whether it is of version 2."""

    def __init__(self, folder: Path, *, is_unified: bool) -> None:
        self._folder, self._is_unified = folder, is_unified

    def command(self, *command: str) -> Sequence[str]:
        """Returns a command line that joins the group and then runs `command`."""
        return ["sh", "-c", _JOIN, str(self._folder), *command]

    def limit(self, max_bytes: int) -> None:
        if self._is_unified:
            self._write("memory.max", max_bytes)
            self._write("memory.swap.max", 0)
        else:
            self._write("memory.limit_in_bytes", max_bytes)
            if self._path("memory.memsw.limit_in_bytes").exists():  # with swap
                self._write("memory.memsw.limit_in_bytes", max_bytes)

    @property
    def peak_bytes(self) -> int:
        """The most memory that the group had, its part of the file cache included."""
        name = "memory.peak" if self._is_unified else "memory.max_usage_in_bytes"
        return int(self._path(name).read_text())

    @property
    def n_killed(self) -> int:
        """Number of processes that the kernel has killed at the limit."""
        name = "memory.events" if self._is_unified else "memory.oom_control"
        rows = (line.split() for line in self._path(name).read_text().splitlines())
        return int(dict(rows)["oom_kill"])

    def remove(self) -> None:
        """Removes the group as soon as its last process has ended."""
        due_s = time.monotonic() + _WITHIN_S
        while True:
            try:
                self._folder.rmdir()
                return
            except OSError:
                if time.monotonic() > due_s:
                    raise
                time.sleep(0.1)

    def _path(self, name: str) -> Path:
        return self._folder / name

    def _write(self, name: str, value: int) -> None:
        self._path(name).write_text(str(value))


def _parent() -> tuple[Path, bool]:
    """Returns the group in which a group can be made, and whether it is of version 2."""
    groups = dict(
        line.split(":")[1:] for line in Path("/proc/self/cgroup").read_text().splitlines()
    )
    if "memory" in groups:
        return _MOUNT / "memory" / groups["memory"].lstrip("/"), False
    # a group of version 2 with processes can have no groups with a limit, but the root can
    if "memory" in (_MOUNT / "cgroup.subtree_control").read_text().split():
        return _MOUNT, True
    raise OSError("no memory controller")


@contextlib.contextmanager
def memory_limit(max_bytes: int) -> Iterator[MemoryGroup]:
    """Makes a group whose processes share `max_bytes`; skips the test where that is impossible."""
    try:
        parent, is_unified = _parent()
        folder = parent / f"pinel-test-{os.getpid()}"
        folder.mkdir()
    except OSError as error:
        pytest.skip(f"no group with a memory limit: {error}")
    group = MemoryGroup(folder, is_unified=is_unified)
    try:
        group.limit(max_bytes)
        yield group
    finally:
        group.remove()
