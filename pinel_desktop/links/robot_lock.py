"""Lock file that lets only one run of this PC drive a robot. The file exists only while the robot is driven."""

import contextlib
import hashlib
import os
import tempfile

from filelock import FileLock, Timeout

from pinel_desktop.errors import PinelError
from pinel_desktop.robot.robot_profile import RobotProfile

# Time for another attempt, if the former driver removes the file at this moment.
_ACQUIRE_TIMEOUT_S, _POLL_INTERVAL_S = 0.1, 0.02


class RobotLock:
    """The lock on the robot of a profile. Any thread of the process that acquired the lock may release it."""

    def __init__(self, profile: RobotProfile) -> None:
        self._address = profile.address
        name = hashlib.sha256(f"{profile.link} {profile.address}".encode()).hexdigest()[:16]
        self._path = os.path.join(tempfile.gettempdir(), f"pinel-robot-{name}.lock")
        # All accounts of the PC share the file. Without write access for all, the first account
        # would lock out the others for good.
        self._lock = FileLock(self._path, mode=0o666, thread_local=False)

    def acquire(self) -> None:
        """Acquires the lock. A file that a crash left behind does not block it.

        Raises PinelError `robot_busy_here` if another run holds the lock.
        """
        try:
            self._lock.acquire(timeout=_ACQUIRE_TIMEOUT_S, poll_interval=_POLL_INTERVAL_S)
        except Timeout as error:
            raise PinelError("robot_busy_here", address=self._address) from error

    def release(self) -> None:
        """Removes the file and releases the lock.

        The file is removed before the release. After the release, another process might already hold a lock on it. If
        a process opened the file earlier and locks it now, filelock detects that the file was removed and opens a new
        one. A file of another account cannot be removed. On Windows, filelock itself removes the file.
        """
        if not self._lock.is_locked:
            return
        with contextlib.suppress(OSError):
            os.unlink(self._path)
        self._lock.release()
