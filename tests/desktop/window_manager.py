"""A window manager on a virtual screen: without one no window is minimised or comes forward, and Alt+F4 is two keys."""

import os
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager

_TIMEOUT_S = 30.0


@contextmanager
def window_manager(display: str) -> Iterator[None]:
    """Runs openbox, which manages the screen when the block begins."""
    environment = os.environ | {"DISPLAY": display}
    manager = _started(environment)
    deadline_s = time.monotonic() + _TIMEOUT_S
    while not _is_managed(environment):
        assert time.monotonic() < deadline_s, "no window manager"
        time.sleep(0.05)
        if manager.poll() is not None:  # on a busy PC it was seen to find no display
            manager = _started(environment)
    yield
    manager.terminate()
    manager.wait(10)


def _started(environment: dict[str, str]) -> "subprocess.Popen[bytes]":
    return subprocess.Popen(["openbox"], env=environment, stderr=subprocess.DEVNULL)


def _is_managed(environment: dict[str, str]) -> bool:
    command = ["xdotool", "get_num_desktops"]
    done = subprocess.run(command, env=environment, capture_output=True, check=False)
    return done.returncode == 0
