"""The end of a process that has shown a window."""

import os
import sys
import threading


def end_process(status: int) -> None:
    """Ends the process here where a thread of the window's library would keep it alive for ever.

    A script that is under way when the window closes never answers, and pywebview runs its own on threads that
    Python waits for. Call it last: everything of ours must have been closed. Returns where nothing is in the way.
    """
    others = (thread for thread in threading.enumerate() if thread is not threading.main_thread())
    if any(not thread.daemon for thread in others):
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)
