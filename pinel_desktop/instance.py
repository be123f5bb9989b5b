"""Single instance: one app for each database, ensured by a lock file. An instance file has the address of the app.

The operating system releases the lock when the process ends, however it ends. The instance file may be stale, so it
counts only while the lock is held and its address responds. An app also works without this file, such as on a full
disk.
"""

import contextlib
import errno
import json
import os
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pinel_desktop.database_locations import is_location_missing
from pinel_desktop.errors import PinelError
from pinel_desktop.paths import read_regular

if sys.platform == "win32":  # where a folder cannot be locked
    fcntl = None
else:
    import fcntl

if TYPE_CHECKING:
    from filelock import FileLock

_SECRET_HEADER = "X-Pinel-Secret"  # as in web/guard.py, whose import would delay a second start
_RESPONSE_TIMEOUT_S = 2.0
_STARTING_S = 10.0
_POLL_S = 0.1
# The folder is not writable, and neither is the database, so a second app is harmless.
_NOT_WRITABLE = (errno.EROFS, errno.EACCES, errno.EPERM)


@dataclass(frozen=True, slots=True)
class RunningInstance:
    """The first app, which holds the lock."""

    url: str
    secret: str
    pid: int

    def show(self) -> None:
        """Brings the first app's window forward. Raises PinelError `instance_silent` if the app does not respond."""
        self._ask("show")

    def open(self, file: str) -> None:
        """Like `show`, and leads the first app's pages to where the teacher merges the file."""
        self._ask("open", {"path": file})

    def fresh_link(self) -> str:
        """Returns an address that opens the first app's page once. Raises PinelError `instance_silent`."""
        return str(self._ask("link")["url"])

    def _ask(self, what: str, body: dict[str, str] | None = None) -> dict[str, Any]:
        # imported here, because only a second start sends a request
        import urllib.error  # noqa: PLC0415
        import urllib.request  # noqa: PLC0415

        request = urllib.request.Request(
            f"{self.url}/api/instance/{what}",
            method="POST",
            headers={_SECRET_HEADER: self.secret}
            | ({"Content-Type": "application/json"} if body else {}),
            data=json.dumps(body).encode() if body else None,
        )
        # no proxy, even if the school's network requires one: the address is on this PC
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
    """Another process serves this database; `running` has its address."""

    def __init__(self, running: RunningInstance) -> None:
        super().__init__("already_running", url=running.url, pid=running.pid)
        self.running = running


class InstanceLock:
    """The lock of this process on a database; call `release` at the end."""

    def __init__(self, database: Path) -> None:
        self._database = database
        self._file = database.with_name(f"{database.stem}.instance.json")
        self._lock_file = database.with_name(f"{database.stem}.lock")
        self._lock: FileLock | _FolderLock | None = None
        self._lock_is_parents = False

    @classmethod
    def of_parent(cls, database: Path) -> "InstanceLock":
        """Returns an instance for a child of the process that holds the lock: it only writes the instance file."""
        instance = cls(database)
        instance._lock_is_parents = True
        return instance

    def acquire(self, wait_s: float = _STARTING_S) -> None:
        """Acquires the lock. If the folder is missing or read-only, continues without a lock, which is harmless.

        Raises:
            AlreadyRunningError: another process has the lock and responds.
            PinelError: `instance_silent` if the other process has not responded after `wait_s`;
                `instance_unreachable` if it has no instance file either.
        """
        deadline = time.monotonic() + wait_s
        while not self._acquired():
            running = self._running()
            if running is not None:
                raise AlreadyRunningError(running)
            if time.monotonic() >= deadline:
                raise self._no_response()
            time.sleep(_POLL_S)  # the other process may be starting or ending

    def announce(self, url: str, secret: str) -> None:
        """Writes the instance file, readable by this user alone; continues without it if it cannot be written."""
        if not self._is_ours():
            return
        text = json.dumps({"url": url, "secret": secret, "pid": os.getpid()})
        self._remove_file()
        try:
            handle = os.open(self._file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
            with os.fdopen(handle, "w", encoding="utf-8") as file:
                file.write(text)
        except OSError:
            self._remove_file()  # an empty file would mean an app that does not respond

    def release(self) -> None:
        """Removes the instance file and releases the lock."""
        if self._is_ours():
            # if the parent died first, the file may already belong to a later instance
            if self._announced().get("pid") == os.getpid():
                self._remove_file()
            if self._lock is not None:
                self._lock.release()

    def _remove_file(self) -> None:
        # imported here, because the store would delay the window
        from storage.file.open_files import delete  # noqa: PLC0415

        with contextlib.suppress(OSError):  # the disk may have become read-only
            delete(self._file, missing_ok=True)

    def _is_ours(self) -> bool:
        return self._lock_is_parents or (self._lock is not None and self._lock.is_locked)

    def _acquired(self) -> bool:
        if is_location_missing(self._database):  # nothing is made where a stick is to be mounted
            return True
        # imported here, because the app behind a window needs no lock and must start fast
        from filelock import FileLock, Timeout  # noqa: PLC0415

        # not thread-local, because another thread may announce the address, which checks the lock
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
        """Locks the folder itself, if the path of the lock file is no file, such as a folder."""
        if fcntl is None:
            return True
        self._lock = _FolderLock(self._file.parent)
        return self._lock.acquire()

    def _running(self) -> RunningInstance | None:
        """Returns the process that holds the lock, if its file can be read and its address responds; else None."""
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
    """A lock on a folder, with the methods of `FileLock` that `InstanceLock` uses."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._handle: int | None = None

    @property
    def is_locked(self) -> bool:
        return self._handle is not None

    def acquire(self) -> bool:
        """Returns False if another process has the lock. If the folder cannot be locked at all, returns True."""
        assert fcntl is not None  # see `_try_folder_lock`
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
        """Releases the lock."""
        if self._handle is not None:
            os.close(self._handle)
            self._handle = None
