"""What the app tells the node: lines on standard input, read by a thread of its own."""

import os
import threading


class Inbox:
    """Lines of the app, from the start of the process: who waits for something else hears when they end.

    Attributes:
        ended: is set when the input has ended, or a line could not be followed.
    """

    def __init__(self):
        self.ended = threading.Event()
        self._handler = None
        threading.Thread(target=self._work, daemon=True).start()

    def follow(self, handler):
        """From here on each line goes to `handler`; what came before is stale."""
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
        part = os.read(0, 65536)  # not over sys.stdin, whose lock would outlive this thread
        if not part:
            return
        *lines, rest = (rest + part).split(b"\n")
        yield from lines
