"""Runs the package in another system's folder, as an ordinary user without network, and prints what was found as JSON.

    unshare --mount --net --ipc --pid --fork --kill-child python3 packaging/in_system.py SYSTEM PACKAGE SCREENSHOT

Called by systems.py as root. All is imported before the root folder changes: later there is another Python, or none.
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
# the page has thousands; a screen without a window, or with an empty one, has a few
MIN_COLOURS = 100


def enter(system: Path, package: Path) -> None:
    """Makes `system` the root folder, with the package in it, read-only; from then on as an ordinary user."""
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
    """Runs a virtual screen, whose picture is a file in the home folder; yields its name."""
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
    """Starts the packaged program with nothing but a home, a language and a screen."""
    return subprocess.Popen(
        [str(_PROGRAM), *arguments],
        env={"HOME": str(_HOME), "LANG": "pt_BR.UTF-8", "DISPLAY": display},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        encoding="utf-8",
    )


def picture() -> tuple[int, bytes]:
    """The picture that the screen shows now, in the format XWD, and its number of colours."""
    with (
        (_HOME / "Xvfb_screen0").open("rb") as file,
        mmap.mmap(file.fileno(), 0, prot=mmap.PROT_READ) as mapped,
    ):
        data = mapped[:]
    # header's length; number of entries of the colour table behind it, 12 bytes each
    start = struct.unpack_from(">I", data)[0] + 12 * struct.unpack_from(">I", data, 76)[0]
    return len(set(memoryview(data)[start:].cast("I"))), data


def watched(process: "subprocess.Popen[str]") -> tuple[str, str, int, bytes]:
    """Output of a program, and the last picture of the screen before the program emptied it, if it ever drew."""
    deadline, drawn = time.monotonic() + _TIMEOUT_S, picture()
    while True:
        try:
            return *process.communicate(timeout=_PERIOD_S), *drawn
        except subprocess.TimeoutExpired:
            now = picture()
            drawn = now if now[0] >= MIN_COLOURS else drawn
            if time.monotonic() > deadline:  # it ends with this namespace
                return "", f"still running after {_TIMEOUT_S} s", *drawn


def main() -> None:
    system, package, screenshot = map(Path, sys.argv[1:])
    with screenshot.open("wb") as file:
        enter(system, package)
        with screen() as display:
            doctor, doctor_stderr = run(display, "doctor", "--json").communicate(timeout=_TIMEOUT_S)
            started = time.monotonic()
            check, check_stderr, n_colours, shown = watched(run(display, "--self-check"))
            seconds = round(time.monotonic() - started, 1)
        file.write(shown)
    found = {
        "doctor": doctor,
        "check": check,
        "stderr": doctor_stderr + check_stderr,
        "n_colours": n_colours,
        "check_s": seconds,
    }
    print(json.dumps(found))


if __name__ == "__main__":
    main()
