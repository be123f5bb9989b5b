"""Installs the package in another system's folder, tries it as an ordinary user without network, and removes it.

    unshare --mount --net --ipc --pid --fork --kill-child python3 packaging/in_system.py SYSTEM STICK SCREENSHOT

trial.py calls it as root; it prints the results as JSON. It imports everything before the root folder changes, because
the new root folder has another Python, or none.
"""

import contextlib
import fcntl
import json
import mmap
import os
import pwd  # noqa: F401 - Popen(user=...) imports it
import socket
import struct
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

_USER = 1000
_HOME = Path("/home/aluna")
_DATA = _HOME / ".local" / "share" / "pinel"
_STICK = Path("/media/aluna/PEN DRIVE/PINEL 1º ano")
_PROGRAM = "/usr/bin/pinel"
_AUTOSTART = Path("/etc/xdg/autostart/pinel-desktop.desktop")
_SIZE = "1366x768x24"
_TIMEOUT_S = 240
_PERIOD_S = 0.5
_AS_ROOT = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "LANG": "pt_BR.UTF-8"}
# The app's first page has 2,600 colours, its header alone 340; a screen without a window has one.
MIN_COLOURS = 1000


def enter(system: Path, stick: Path) -> None:
    """Makes `system` the root folder, with the stick mounted read-only."""
    mounted = system / _STICK.relative_to("/")
    mounted.mkdir(parents=True, exist_ok=True)
    for command in (
        ("mount", "-t", "proc", "proc", str(system / "proc")),
        ("mount", "-t", "tmpfs", "-o", "mode=1777", "tmpfs", str(system / "dev" / "shm")),
        ("mount", "-t", "tmpfs", "-o", "mode=1777", "tmpfs", str(system / "tmp")),
        ("mount", "--bind", str(stick), str(mounted)),
        ("mount", "-o", "remount,bind,ro", str(mounted)),
    ):
        subprocess.run(command, check=True)
    _bring_loopback_up()
    home = system / _HOME.relative_to("/")
    home.mkdir(mode=0o700, exist_ok=True)
    os.chown(home, _USER, _USER)
    os.chroot(system)
    os.chdir("/")


def _bring_loopback_up() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        request = struct.pack("16sh", b"lo", 0x1)  # the flag IFF_UP
        fcntl.ioctl(any_socket, 0x8914, request)  # SIOCSIFFLAGS


def as_root(*command: str) -> tuple[int, str]:
    """Runs a command as the technician does; returns its exit status and what it printed."""
    done = subprocess.run(
        command,
        env=_AS_ROOT,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        encoding="utf-8",
        check=False,
    )
    return done.returncode, done.stdout


@contextlib.contextmanager
def screen() -> Iterator[str]:
    """Runs a virtual screen, which writes its picture to a file in the home folder; yields its name."""
    reading, writing = os.pipe()
    command = ["/usr/bin/Xvfb", "-displayfd", str(writing), "-screen", "0", _SIZE]
    with subprocess.Popen(
        [*command, "-nolisten", "tcp", "-fbdir", str(_HOME)],
        pass_fds=[writing],
        stderr=subprocess.DEVNULL,
        user=_USER,
        group=_USER,
        extra_groups=[],
    ) as process:
        os.close(writing)
        try:
            with os.fdopen(reading) as answer:
                yield f":{answer.readline().strip()}"
        finally:
            process.terminate()


def run(display: str, *arguments: str) -> "subprocess.Popen[str]":
    """Starts the installed program as an ordinary user, in an environment with only home, language and screen."""
    return subprocess.Popen(
        [_PROGRAM, *arguments],
        cwd=_HOME,
        env={"HOME": str(_HOME), "LANG": "pt_BR.UTF-8", "DISPLAY": display},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        text=True,
        encoding="utf-8",
        user=_USER,
        group=_USER,
        extra_groups=[],
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


def shown(program: "subprocess.Popen[str]") -> tuple[int, bytes]:
    """Returns the picture of the screen when the program has drawn its page, or at the timeout."""
    deadline, before = time.monotonic() + _TIMEOUT_S, 0
    while True:
        n_colours, data = picture()
        if MIN_COLOURS <= n_colours <= before or time.monotonic() > deadline:
            break
        before = n_colours
        with contextlib.suppress(subprocess.TimeoutExpired):
            program.wait(_PERIOD_S)
    return n_colours, data


def is_kiosk() -> bool:
    """Whether the window's process is in kiosk mode, because the set-up file says so."""
    for file in Path("/proc").glob("[0-9]*/cmdline"):
        with contextlib.suppress(OSError):  # the process has ended meanwhile
            if b"kiosk\0--reason\0setting" in file.read_bytes():
                return True
    return False


def main() -> None:
    system, stick, screenshot = map(Path, sys.argv[1:])
    found: dict[str, object] = {}
    with screenshot.open("wb") as file:
        enter(system, stick)
        started = time.monotonic()
        found["install_status"], found["install"] = as_root("sh", f"{_STICK}/instalar.sh")
        found["install_s"] = round(time.monotonic() - started, 1)
        with screen() as display:
            found["doctor"] = output_of(display, "doctor", "--json")
            started = time.monotonic()
            found["check"] = output_of(display, "--self-check")
            found["check_s"] = round(time.monotonic() - started, 1)
            program = run(display)
            found["n_colours"], data = shown(program)
            file.write(data)
            found["is_kiosk"] = is_kiosk()
            found["at_login"] = _AUTOSTART.exists()
            # the program is open, as in a lab
            remove = ("apt-get", "-q", "-y", "remove", "pinel-desktop")
            found["remove_status"], found["remove"] = as_root(*remove)
            found["end_status"] = program.poll()
        found["is_gone"] = not (Path("/usr/lib/pinel-desktop").exists() or _AUTOSTART.exists())
        found["kept"] = sorted(path.name for path in _DATA.glob("*.db"))
        found["settings"] = (_DATA / "pinel.db.page.json").read_text("utf-8")
    print(json.dumps(found))


if __name__ == "__main__":
    main()
