"""A screen that nobody sees, for trying the window on a PC that has none."""

import os
import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager

from pinel_desktop.errors import PinelError

_TIMEOUT_S = 20


@contextmanager
def virtual_screen(width: int = 1366, height: int = 768) -> Iterator[str]:
    """Runs Xvfb on a free display number and yields its name (":99"), for DISPLAY.

    Raises PinelError `screen_virtual_missing` where Xvfb is not installed or does not start.
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
            number = answer.readline().strip()  # the end of the pipe, should Xvfb die
        if not number:
            raise PinelError("screen_virtual_missing")
        yield f":{number}"
    finally:
        process.terminate()
        process.wait(_TIMEOUT_S)


@contextmanager
def any_screen() -> Iterator[bool]:
    """The PC's own screen, or a virtual one for as long as the block lasts; yields whether it is virtual."""
    if os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"):
        yield False
        return
    with virtual_screen() as display:
        os.environ["DISPLAY"] = display
        try:
            yield True
        finally:
            del os.environ["DISPLAY"]
