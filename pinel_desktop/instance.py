"""One app for one database: a lock, and a file from which a second start learns how to reach the first.

The lock is the system's own, so it is gone when the process is, however it ended; the file may be stale and is
believed only while the lock is held and the address answers. An app works without the file too, as on a full disk.
"""

import contextlib
import errno
import json
import os
import time
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pinel_desktop.database_locations import is_location_missing
from pinel_desktop.errors import PinelError
from pinel_desktop.paths import read_regular

try:
    import fcntl
except ImportError:  # Windows, where a folder cannot be locked
    fcntl = None  # type: ignore[assignment]

if TYPE_CHECKING:
    from filelock import FileLock

_SECRET_HEADER = (
    "X-Pinel-Secret"  # as in web/guard.py, which this must not load: a second start is to be quick
)
_RESPONSE_TIMEOUT_S = 2.0
_STARTING_S = 10.0
_POLL_S = 0.1
# the folder cannot be written, so neither can the database: two apps do each other no harm
_NOT_WRITABLE = (errno.EROFS, errno.EACCES, errno.EPERM)


@dataclass(frozen=True, slots=True)
class RunningInstance:
    """The app that was started first."""

    url: str
    secret: str
    pid: int

    def show(self) -> None:
        """Brings its window forward. Raises PinelError `instance_silent`."""
        self._ask("show")

    def fresh_link(self) -> str:
        """An address that opens its page once. Raises PinelError `instance_silent`."""
        return str(self._ask("link")["url"])

    def _ask(self, what: str) -> dict[str, Any]:
        # only a second start asks, and every start would have to wait for it
        import urllib.error  # noqa: PLC0415
        import urllib.request  # noqa: PLC0415

        request = urllib.request.Request(
            f"{self.url}/api/instance/{what}", method="POST", headers={_SECRET_HEADER: self.secret}
        )
        # no proxy: the address is on this PC, whatever the school's network wants
        opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        try:
            with opener.open(request, timeout=_RESPONSE_TIMEOUT_S) as answer:
                found: dict[str, Any] = json.load(answer)
                return found
        except urllib.error.HTTPError as error:
            error.close()
            raise PinelError("instance_silent", pid=self.pid) from error
        except (OSError, ValueError) as error:
            raise PinelError("instance_silent", pid=self.pid) from error


class AlreadyRunningError(PinelError):
    """Another process has the database; `running` reaches it."""

    def __init__(self, running: RunningInstance) -> None:
        super().__init__("already_running", url=running.url, pid=running.pid)
        self.running = running


class InstanceLock:
    """The lock of this process on a database; `release` it at the end."""

    def __init__(self, database: Path) -> None:
        self._database = database
        self._file = database.with_name(f"{database.stem}.instance.json")
        self._lock_file = database.with_name(f"{database.stem}.lock")
        self._lock: FileLock | _FolderLock | None = None
        self._lock_is_parents = False

    @classmethod
    def of_parent(cls, database: Path) -> "InstanceLock":
        """For a process whose parent has the lock and keeps it: it only writes the file."""
        instance = cls(database)
        instance._lock_is_parents = True
        return instance

    def acquire(self, wait_s: float = _STARTING_S) -> None:
        """Takes the lock. In a folder that cannot be written, or is away, there is none, and no harm in going without.

        Raises:
            AlreadyRunningError: another process has it and answers.
            PinelError: `instance_silent` when it has not answered after `wait_s`, `instance_unreachable` when it has
                no file either.
        """
        deadline = time.monotonic() + wait_s
        while not self._acquired():
            running = self._running()
            if running is not None:
                raise AlreadyRunningError(running)
            if time.monotonic() >= deadline:
                raise self._no_response()
            time.sleep(_POLL_S)  # the other one may be starting, or be about to end

    def announce(self, url: str, secret: str) -> None:
        """Writes how to reach this process, readable by this user alone; goes without where that cannot be written."""
        if not self._is_ours():
            return
        text = json.dumps({"url": url, "secret": secret, "pid": os.getpid()})
        try:
            self._file.unlink(missing_ok=True)
            handle = os.open(self._file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
            with os.fdopen(handle, "w", encoding="utf-8") as file:
                file.write(text)
        except OSError:
            self._remove_file()  # an empty one would say that there is an app that does not answer

    def release(self) -> None:
        """Takes the file away and gives the lock back."""
        if self._is_ours():
            # a successor's file stays, when the parent died first
            if self._announced().get("pid") == os.getpid():
                self._remove_file()
            if self._lock is not None:
                self._lock.release()

    def _remove_file(self) -> None:
        with contextlib.suppress(OSError):  # the disk may have become read-only
            self._file.unlink(missing_ok=True)

    def _is_ours(self) -> bool:
        return self._lock_is_parents or (self._lock is not None and self._lock.is_locked)

    def _acquired(self) -> bool:
        if is_location_missing(self._database):  # nothing is made where a stick is to be mounted
            return True
        # the app behind a window, whose start the page waits for, takes no lock
        from filelock import FileLock, Timeout  # noqa: PLC0415

        # the thread that takes the lock need not be the one that announces the address
        lock = FileLock(str(self._lock_file), thread_local=False)
        try:
            self._file.parent.mkdir(0o700, parents=True, exist_ok=True)
            lock.acquire(timeout=0)
        except Timeout:
            return False
        except OSError as error:
            return error.errno in _NOT_WRITABLE or self._try_folder_lock()
        self._lock = lock
        return True

    def _try_folder_lock(self) -> bool:
        """Locks the folder itself, where something that is no file has the name of the lock file."""
        if fcntl is None:
            return True
        self._lock = _FolderLock(self._file.parent)
        return self._lock.acquire()

    def _running(self) -> RunningInstance | None:
        """The process that holds the lock, if its file can be read and its address answers."""
        announced = self._announced()
        try:
            running = RunningInstance(
                str(announced["url"]), str(announced["secret"]), int(str(announced["pid"]))
            )
            running.fresh_link()
        except (KeyError, ValueError, PinelError):
            return None
        return running

    def _announced(self) -> dict[str, object]:
        try:
            found = json.loads(read_regular(self._file))
        except (OSError, ValueError, RecursionError):
            return {}
        return found if isinstance(found, dict) else {}

    def _no_response(self) -> PinelError:
        if self._file.is_file():
            return PinelError("instance_silent", pid=self._announced().get("pid", "?"))
        return PinelError("instance_unreachable", path=str(self._file))


class _FolderLock:
    """A lock on a folder, with what `Instance` needs of a `FileLock`."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._handle: int | None = None

    @property
    def is_locked(self) -> bool:
        return self._handle is not None

    def acquire(self) -> bool:
        """False where another process has it. A folder that cannot be locked counts as locked."""
        try:
            self._handle = os.open(self._folder, os.O_RDONLY)
            fcntl.flock(self._handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            self.release()
            return False
        except OSError:
            return True
        return True

    def release(self) -> None:
        """Gives it back."""
        if self._handle is not None:
            os.close(self._handle)
            self._handle = None
