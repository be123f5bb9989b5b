"""Reads the app's messages to the node: lines on standard input, on their own thread."""

import os
import threading


class Inbox:
    """Reads standard input from the start of the process, so that its end also aborts the search for the robot.

    Attributes:
        ended: set once the input has ended, or `handler` has raised an error.
    """

    def __init__(self):
        self.ended = threading.Event()
        self._handler = None
        threading.Thread(target=self._work, daemon=True).start()

    def follow(self, handler):
        """Passes each line from now on to `handler`; earlier lines are dropped, because they are stale."""
        self._handler = handler

    def _work(self):
        try:
            for line in _lines():
                if self._handler is not None:
                    self._handler(line)
        finally:
            self.ended.set()


def _lines():
    rest = b""
    while True:
        part = os.read(0, 65536)  # not sys.stdin: this thread could hold its lock at the exit
        if not part:
            return
        *lines, rest = (rest + part).split(b"\n")
        yield from lines
