"""Ends a process that has shown a window, or continues it as another program."""

import os
import subprocess
import sys
import threading
from typing import NoReturn

from pinel_desktop.processes.log_file import close_log


def end_process(status: int) -> None:
    """Exits at once if a non-daemon thread of pywebview would keep the process alive; otherwise returns.

    pywebview runs its scripts on such threads, and a script that is running when the window closes never returns. Call
    this last, after closing all other resources.
    """
    others = (thread for thread in threading.enumerate() if thread is not threading.main_thread())
    if any(not thread.daemon for thread in others):
        close_log()
        _flush_streams()
        os._exit(status)


def become(command: list[str]) -> NoReturn:
    """Runs another program in place of this one, with the same process id where the system can do that.

    Call this last, after closing all other resources.
    """
    close_log()
    _flush_streams()
    if sys.platform == "win32":  # where a replaced process would end for the one that waits for it
        subprocess.Popen(command, stdin=subprocess.DEVNULL)
        os._exit(0)
    os.execv(command[0], command)


def _flush_streams() -> None:
    for stream in (sys.stdout, sys.stderr):
        if stream is not None:  # the windowed program on Windows has neither
            stream.flush()
