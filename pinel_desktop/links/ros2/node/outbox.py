"""Writes the node's messages to the app: JSON lines on standard output (`node.py` lists their types)."""

import json
import math
import os
import threading
import time

# minimum time in s between two lines of a kind; of more frequent lines only the newest is written
MIN_INTERVALS_S = {
    "odometry": 0.005,
    "localised": 0.02,
    "scan": 0.1,
    "range": 0.1,
    "points": 0.1,
    "battery": 1.0,
}
CLOSE_TIMEOUT_S = 1.0


class Outbox:
    """Queue of lines, written by its own thread, so that an app that does not read blocks nobody.

    Of each kind and key only the newest line is queued.
    """

    def __init__(self):
        self._waiting, self._written_s = {}, {}
        self._changed, self._ending = threading.Condition(), False
        self._thread = threading.Thread(target=self._work, daemon=True)
        self._thread.start()

    def put(self, kind, key="", **fields):
        """Queues a line; never waits."""
        with self._changed:
            self._waiting[kind, key] = {"type": kind, **fields}
            self._changed.notify()

    def drop(self, kind):
        """Removes the queued lines of a kind, because they are outdated."""
        with self._changed:
            self._waiting = {
                which: line for which, line in self._waiting.items() if which[0] != kind
            }

    def close(self):
        """Writes the queued lines; gives up after `CLOSE_TIMEOUT_S` if the app does not read."""
        with self._changed:
            self._ending = True
            self._changed.notify()
        self._thread.join(CLOSE_TIMEOUT_S)

    def _work(self):
        try:
            while True:
                lines = self._due()
                if not lines:
                    return
                text = "".join(json.dumps(line) + "\n" for line in lines).encode()
                while text:  # not sys.stdout: this thread could hold its lock at the exit
                    text = text[os.write(1, text) :]
        except OSError:
            pass  # the app has exited: standard input ends, too

    def _due(self):
        """Waits for lines that are due and returns them; returns none at the end."""
        with self._changed:
            while True:
                now_s = time.monotonic()
                wait_s = {which: self._wait_s(which, now_s) for which in self._waiting}
                due = [which for which, left_s in wait_s.items() if left_s <= 0.0]
                if due or self._ending:
                    self._written_s.update(dict.fromkeys(due, now_s))
                    return [self._waiting.pop(which) for which in due]
                self._changed.wait(min(wait_s.values(), default=None))

    def _wait_s(self, which, now_s):
        if self._ending:
            return 0.0
        return self._written_s.get(which, -math.inf) + MIN_INTERVALS_S.get(which[0], 0.0) - now_s
