"""Queue of the messages to a process: a full pipe blocks no caller, and the queue has a size limit."""

import contextlib
import queue
import threading
from typing import BinaryIO

# Far more than a responsive process ever leaves in the queue; a single line may be longer.
MAX_WAITING = 16_000_000  # bytes


class Outbox:
    """Queue of lines for one process, written in order by a thread of its own; thread-safe."""

    def __init__(self) -> None:
        self._lines: queue.SimpleQueue[bytes | None] = queue.SimpleQueue()
        self._lock = threading.Lock()
        self._n_waiting = 0

    def put(self, line: bytes) -> bool:
        """Adds a line without waiting; if the queue is full, because the process does not read, returns False."""
        with self._lock:
            if self._n_waiting and self._n_waiting + len(line) > MAX_WAITING:
                return False
            self._n_waiting += len(line)
            self._lines.put(line)
            return True

    def end(self) -> None:
        """Closes the pipe after all lines in the queue are written."""
        self._lines.put(None)

    def start_writing(self, pipe: BinaryIO, name: str) -> None:
        """Starts the thread that writes to a pipe, until `end` or until the pipe has no reader."""
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
