"""The standard streams of a process whose standard output carries messages."""

import os
import sys


def reserve_output() -> int:
    """Returns a descriptor of the standard output, and sends what libraries print to the standard error instead.

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
