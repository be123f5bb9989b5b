"""Runs the package in another system's folder, as an ordinary user without network, and prints the results as JSON.

    unshare --mount --net --ipc --pid --fork --kill-child python3 packaging/in_system.py SYSTEM PACKAGE SCREENSHOT

systems.py calls it as root. It imports everything before the root folder changes, because the new root folder has
another Python, or none.
"""

import contextlib
import fcntl
import json
import mmap
import os
import socket
import struct
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

_USER = 1000
_HOME = Path("/home/aluna")
_PROGRAM = Path("/opt/Laboratório de Robótica 1/PINEL (cópia)/pinel")
_SIZE = "1366x768x24"
_TIMEOUT_S = 240
_PERIOD_S = 0.5
# The app's first page has 2,600 colours, its header alone 340; a screen without a window has one.
MIN_COLOURS = 1000


def enter(system: Path, package: Path) -> None:
    """Makes `system` the root folder, with the package mounted read-only, and switches to an ordinary user."""
    program = system / _PROGRAM.parent.relative_to("/")
    program.mkdir(parents=True, exist_ok=True)
    for command in (
        ("mount", "-t", "proc", "proc", str(system / "proc")),
        ("mount", "-t", "tmpfs", "-o", "mode=1777", "tmpfs", str(system / "dev" / "shm")),
        ("mount", "-t", "tmpfs", "-o", "mode=1777", "tmpfs", str(system / "tmp")),
        ("mount", "--bind", str(package), str(program)),
        ("mount", "-o", "remount,bind,ro", str(program)),
    ):
        subprocess.run(command, check=True)
    _bring_loopback_up()
    home = system / _HOME.relative_to("/")
    home.mkdir(mode=0o700, exist_ok=True)
    os.chown(home, _USER, _USER)
    os.chroot(system)
    os.chdir(_HOME)
    os.setgroups([])
    os.setgid(_USER)
    os.setuid(_USER)


def _bring_loopback_up() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        request = struct.pack("16sh", b"lo", 0x1)  # the flag IFF_UP
        fcntl.ioctl(any_socket, 0x8914, request)  # SIOCSIFFLAGS


@contextlib.contextmanager
def screen() -> Iterator[str]:
    """Runs a virtual screen, which writes its picture to a file in the home folder; yields its name."""
    reading, writing = os.pipe()
    command = ["/usr/bin/Xvfb", "-displayfd", str(writing), "-screen", "0", _SIZE]
    with subprocess.Popen(
        [*command, "-nolisten", "tcp", "-fbdir", str(_HOME)],
        pass_fds=[writing],
        stderr=subprocess.DEVNULL,
    ) as process:
        os.close(writing)
        try:
            with os.fdopen(reading) as answer:
                yield f":{answer.readline().strip()}"
        finally:
            process.terminate()


def run(display: str, *arguments: str) -> "subprocess.Popen[str]":
    """Starts the packaged program in an environment with only home, language and screen."""
    return subprocess.Popen(
        [str(_PROGRAM), *arguments],
        env={"HOME": str(_HOME), "LANG": "pt_BR.UTF-8", "DISPLAY": display},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        text=True,
        encoding="utf-8",
    )


def output_of(display: str, *arguments: str) -> str:
    """Returns the program's standard output; its standard error is the standard error of this script."""
    return run(display, *arguments).communicate(timeout=_TIMEOUT_S)[0]


def picture() -> tuple[int, bytes]:
    """Returns the current picture of the screen, in the format XWD, and its number of colours."""
    with (
        (_HOME / "Xvfb_screen0").open("rb") as file,
        mmap.mmap(file.fileno(), 0, prot=mmap.PROT_READ) as mapped,
    ):
        data = mapped[:]
    # the header's length; the number of entries of the colour table after the header, 12 bytes each
    start = struct.unpack_from(">I", data)[0] + 12 * struct.unpack_from(">I", data, 76)[0]
    return len(set(memoryview(data)[start:].cast("I"))), data


def shown(display: str) -> tuple[int, bytes]:
    """Opens the program as a person does; returns the picture when the page is drawn, or at the timeout."""
    program, deadline, before = run(display), time.monotonic() + _TIMEOUT_S, 0
    while True:
        n_colours, data = picture()
        if MIN_COLOURS <= n_colours <= before or time.monotonic() > deadline:
            break
        before = n_colours
        with contextlib.suppress(subprocess.TimeoutExpired):
            program.wait(_PERIOD_S)
    program.kill()  # the end of this process namespace ends its other processes
    return n_colours, data


def main() -> None:
    system, package, screenshot = map(Path, sys.argv[1:])
    found: dict[str, object]
    with screenshot.open("wb") as file:
        enter(system, package)
        with screen() as display:
            found = {"doctor": output_of(display, "doctor", "--json")}
            started = time.monotonic()
            found["check"] = output_of(display, "--self-check")
            found["check_s"] = round(time.monotonic() - started, 1)
            found["n_colours"], data = shown(display)
        file.write(data)
    print(json.dumps(found))


if __name__ == "__main__":
    main()
