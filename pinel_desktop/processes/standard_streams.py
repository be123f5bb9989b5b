"""The standard streams of this process and of its child processes."""

import io
import os
import subprocess
import sys


def use_utf8() -> None:
    """Reads and prints UTF-8 in pipes and files, as Linux does. Windows' own encoding lacks many characters."""
    for stream in (sys.stdin, sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # the windowed program on Windows has none
            stream.reconfigure(encoding="utf-8")


def error_output() -> int | None:
    """Returns what a child process gets as its standard error, for `subprocess`: the one of this process.

    The windowed program on Windows has none, and its child would get a broken pipe; it gets the null device instead.
    """
    return subprocess.DEVNULL if sys.stderr is None else None


def reserve_output() -> int:
    """Returns a descriptor of the standard output, for messages; what libraries print goes to the standard error.

    Call it before anything prints. A process whose parent has no standard error to give, such as the windowed program
    on Windows, gets the null device as its standard error.
    """
    if sys.stderr is None:
        null = os.open(os.devnull, os.O_WRONLY)
        if null != 2:
            os.dup2(null, 2)
            os.close(null)
        sys.stderr = os.fdopen(2, "w", encoding="utf-8", closefd=False)
    output = os.dup(1)
    os.dup2(2, 1)
    return output
