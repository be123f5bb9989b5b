"""One run of this PC drives a robot: a lock file, which is there only while somebody drives."""

import contextlib
import hashlib
import os
import tempfile

from filelock import FileLock, Timeout

from pinel_desktop.errors import PinelError
from pinel_desktop.robot.robot_profile import RobotProfile

# For another attempt where the one who drove removes the file at this very moment.
_ACQUIRE_TIMEOUT_S, _POLL_INTERVAL_S = 0.1, 0.02


class RobotLock:
    """The lock on the robot of a record; every thread of the process that acquired it may release it."""

    def __init__(self, record: RobotProfile) -> None:
        self._address = record.address
        name = hashlib.sha256(f"{record.link} {record.address}".encode()).hexdigest()[:16]
        self._path = os.path.join(tempfile.gettempdir(), f"pinel-robot-{name}.lock")
        # All accounts of the PC share the file: whoever drove first must not keep the others from it for good.
        self._lock = FileLock(self._path, mode=0o666, thread_local=False)

    def acquire(self) -> None:
        """Raises PinelError `robot_busy_here`. A file that a crash left behind is no obstacle."""
        try:
            self._lock.acquire(timeout=_ACQUIRE_TIMEOUT_S, poll_interval=_POLL_INTERVAL_S)
        except Timeout as error:
            raise PinelError("robot_busy_here", address=self._address) from error

    def release(self) -> None:
        """Removes the file while it is locked, so that nobody loses one that he has just locked.

        Who had opened it before, and locks it now, finds that it has no name any more and opens the next one: filelock
        does so. A file of another account cannot be removed; one of Windows is removed by filelock.
        """
        if not self._lock.is_locked:
            return
        with contextlib.suppress(OSError):
            os.unlink(self._path)
        self._lock.release()
