"""What waits to be written to a process: a pipe that is full holds up nobody, and the memory for it has a bound."""

import contextlib
import queue
import threading
from typing import BinaryIO

# far more than a process that reads ever leaves waiting; a line that waits alone may be longer
MAX_WAITING = 16_000_000  # octets


class Outbox:
    """Lines for one process, written in order by a thread of its own; thread-safe."""

    def __init__(self) -> None:
        self._lines: queue.SimpleQueue[bytes | None] = queue.SimpleQueue()
        self._lock = threading.Lock()
        self._n_waiting = 0

    def put(self, line: bytes) -> bool:
        """Takes a line without waiting; False when the process does not read, and too much waits already."""
        with self._lock:
            if self._n_waiting and self._n_waiting + len(line) > MAX_WAITING:
                return False
            self._n_waiting += len(line)
            self._lines.put(line)
            return True

    def end(self) -> None:
        """Lets the pipe end after all that was put."""
        self._lines.put(None)

    def start_writing(self, pipe: BinaryIO, name: str) -> None:
        """Writes to a pipe from now on, until the end or until nobody reads it any more."""
        threading.Thread(target=self._write, args=(pipe,), name=name, daemon=True).start()

    def _write(self, pipe: BinaryIO) -> None:
        with contextlib.suppress(OSError):  # the process has ended; its reader reports it
            while (line := self._lines.get()) is not None:
                pipe.write(line)
                pipe.flush()
                with self._lock:
                    self._n_waiting -= len(line)
        with contextlib.suppress(OSError):
            pipe.close()
