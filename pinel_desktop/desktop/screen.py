"""A virtual screen (Xvfb), for testing the window on a PC without a display."""

import os
import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager

from pinel_desktop.desktop.backends import Pc
from pinel_desktop.errors import PinelError

_TIMEOUT_S = 20


@contextmanager
def virtual_screen(width: int = 1366, height: int = 768) -> Iterator[str]:
    """Runs Xvfb on a free display number and yields its name (":99"), for DISPLAY.

    Raises PinelError `screen_virtual_missing` if Xvfb is not installed or does not start.
    """
    program = shutil.which("Xvfb")
    if program is None:
        raise PinelError("screen_virtual_missing")
    reading, writing = os.pipe()
    command = [
        program,
        "-displayfd",
        str(writing),
        "-screen",
        "0",
        f"{width}x{height}x24",
        "-nolisten",
        "tcp",
    ]
    process = subprocess.Popen(
        command, pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    os.close(writing)
    try:
        with os.fdopen(reading) as answer:
            number = answer.readline().strip()  # empty if Xvfb dies
        if not number:
            raise PinelError("screen_virtual_missing")
        yield f":{number}"
    finally:
        process.terminate()
        process.wait(_TIMEOUT_S)


@contextmanager
def any_screen() -> Iterator[bool]:
    """Uses the PC's display, or a virtual one during the context; yields True if it is virtual."""
    if Pc().has_screen:
        yield False
        return
    with virtual_screen() as display:
        os.environ["DISPLAY"] = display
        try:
            yield True
        finally:
            del os.environ["DISPLAY"]
