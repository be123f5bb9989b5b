"""Ends a process that has shown a window."""

import os
import sys
import threading


def end_process(status: int) -> None:
    """Exits at once if a non-daemon thread of pywebview would keep the process alive; otherwise returns.

    pywebview runs its scripts on such threads, and a script that is running when the window closes never returns. Call
    this last, after closing all other resources.
    """
    others = (thread for thread in threading.enumerate() if thread is not threading.main_thread())
    if any(not thread.daemon for thread in others):
        for stream in (sys.stdout, sys.stderr):
            if stream is not None:  # the windowed program on Windows has neither
                stream.flush()
        os._exit(status)
