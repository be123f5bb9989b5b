"""Tries the package in another system's folder as a school does, without network, and prints the results as JSON.

    unshare --mount --net --ipc --pid --fork --kill-child python3 packaging/in_system.py SYSTEM STICKS SCREENSHOT

trial.py calls it as root and judges the results. STICKS has a folder for each stick. It imports everything before the
root folder changes, because the new root folder has another Python, or none.
"""

import contextlib
import fcntl
import json
import mmap
import os
import pwd  # noqa: F401 - Popen(user=...) imports it
import shutil
import socket
import struct
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

import pupil  # beside this file, as the next one
import smoke

_USER = 1000
_HOME = Path("/home/aluna")
_DATA = _HOME / ".local" / "share" / "pinel"
_STICKS = Path("/media/aluna/PEN DRIVE")
_PROGRAM = "/usr/bin/pinel"
_PACKAGE = Path("/usr/lib/pinel-desktop")
_RUNTIME = Path("/tmp/runtime")  # of the session, in place of /run/user/1000
_AUTOSTART = Path("/etc/xdg/autostart/pinel-desktop.desktop")
_SIZE = "1366x768x24"
_TIMEOUT_S = 240
_PERIOD_S = 0.5
_AS_ROOT = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "LANG": "pt_BR.UTF-8"}
_AS_USER = {"HOME": str(_HOME), "LANG": "pt_BR.UTF-8"}
_LAUNCHER = (
    *("/usr/bin/setpriv", f"--reuid={_USER}", f"--regid={_USER}", "--clear-groups"),
    *("/usr/bin/env", "-i", *(f"{name}={value}" for name, value in _AS_USER.items())),
)
_BUS_OPTIONS = ("--session", "--nofork", "--print-address")
# texts of the page and of the scripts
_PASSED, _CLOSED = "¡Lo lograron!", "O PINEL está aberto e vai ser fechado"
_DAMAGED = "Um arquivo do pendrive está danificado ou falta."
_UNFINISHED = "A instalação não terminou."
_READ_ONLY = "No se puede guardar en esta computadora."
# The app's first page has 2,600 colours, its header alone 340; a screen without a window has one.
MIN_COLOURS = 1000


def enter(system: Path, sticks: Path) -> None:
    """Makes `system` the root folder, with the sticks mounted read-only."""
    mounted = system / _STICKS.relative_to("/")
    mounted.mkdir(parents=True, exist_ok=True)
    for command in (
        ("mount", "-t", "proc", "proc", str(system / "proc")),
        ("mount", "-t", "tmpfs", "-o", "mode=1777", "tmpfs", str(system / "dev" / "shm")),
        ("mount", "-t", "tmpfs", "-o", "mode=1777", "tmpfs", str(system / "tmp")),
        ("mount", "--bind", str(sticks), str(mounted)),
        ("mount", "-o", "remount,bind,ro", str(mounted)),
    ):
        subprocess.run(command, check=True)
    _bring_loopback_up()
    with (system / "etc" / "passwd").open("a", encoding="utf-8") as accounts:
        accounts.write(f"aluna:x:{_USER}:{_USER}::{_HOME}:/bin/sh\n")
    for folder in (_HOME, _RUNTIME):
        inside = system / folder.relative_to("/")
        inside.mkdir(mode=0o700, exist_ok=True)
        os.chown(inside, _USER, _USER)
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
    """Runs a virtual screen, which writes its picture to a file; yields its name."""
    reading, writing = os.pipe()
    command = ["/usr/bin/Xvfb", "-displayfd", str(writing), "-screen", "0", _SIZE]
    with subprocess.Popen(
        [*command, "-nolisten", "tcp", "-fbdir", str(_RUNTIME)],
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


@contextlib.contextmanager
def session_bus() -> Iterator[str]:
    """Runs the D-Bus of a desktop's session; yields its address."""
    with subprocess.Popen(
        [*_LAUNCHER, f"XDG_RUNTIME_DIR={_RUNTIME}", "/usr/bin/dbus-daemon", *_BUS_OPTIONS],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    ) as process:
        assert process.stdout is not None
        try:
            yield process.stdout.readline().strip()
        finally:
            process.terminate()


def run(*arguments: str, **environment: str) -> "subprocess.Popen[str]":
    """Starts the installed program as an ordinary user; its environment is home, language and `environment`."""
    variables = [f"{name}={value}" for name, value in environment.items()]
    return subprocess.Popen(
        [*_LAUNCHER, *variables, _PROGRAM, *arguments],
        cwd="/",
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        encoding="utf-8",
    )


def picture() -> tuple[int, bytes]:
    """Returns the current picture of the screen, in the format XWD, and its number of colours."""
    with (
        (_RUNTIME / "Xvfb_screen0").open("rb") as file,
        mmap.mmap(file.fileno(), 0, prot=mmap.PROT_READ) as mapped,
    ):
        data = mapped[:]
    # the header's length; the number of entries of the colour table after the header, 12 bytes each
    start = struct.unpack_from(">I", data)[0] + 12 * struct.unpack_from(">I", data, 76)[0]
    return len(set(memoryview(data)[start:].cast("I"))), data


def is_drawn(program: "subprocess.Popen[str]") -> bool | str:
    """Waits until the program has drawn its page; returns False at the timeout, or what it says if it ends."""
    deadline, before = time.monotonic() + _TIMEOUT_S, 0
    while time.monotonic() < deadline:
        if program.poll() is not None:
            return program.communicate()[0]
        n_colours, _ = picture()
        if MIN_COLOURS <= n_colours <= before:
            return True
        before = n_colours
        with contextlib.suppress(subprocess.TimeoutExpired):
            program.wait(_PERIOD_S)
    return False


def is_kiosk() -> bool:
    """Whether the window's process is in kiosk mode, because the set-up file says so."""
    for file in Path("/proc").glob("[0-9]*/cmdline"):
        with contextlib.suppress(OSError):  # the process has ended meanwhile
            if b"kiosk\0--reason\0setting" in file.read_bytes():
                return True
    return False


class School:
    """A PC of a school: what happens to PINEL on it, in the order of the methods; `found` holds the results."""

    def __init__(self, display: str, bus: str, screenshot: BinaryIO) -> None:
        self.found: dict[str, object] = {}
        self._screenshot = screenshot
        self._bare = {"DISPLAY": display}
        session = {"DBUS_SESSION_BUS_ADDRESS": bus, "XDG_RUNTIME_DIR": str(_RUNTIME)}
        self._session = self._bare | session

    def install(self) -> "subprocess.Popen[str]":
        """Installs from a copy that was cut off, and from an intact one; opens PINEL for the first time."""
        self.found["cut_said"] = refused("cut", _DAMAGED)
        self.found["cut_left"] = _PACKAGE.exists()
        started = time.monotonic()
        self.found["install_status"], self.found["install"] = install("first")
        self.found["install_s"] = round(time.monotonic() - started, 1)
        program = self._open("drawn")
        self.found["kiosk_s"] = round(time.monotonic() - started, 1)
        self.found["is_kiosk"], self.found["at_login"] = is_kiosk(), _AUTOSTART.exists()
        return program

    def solve(self) -> None:
        """Makes a group and solves the lesson's mission, 3 m straight ahead, by clicks."""
        ana = pupil.Pupil(_USER, self._session)
        ana.click("Nombre del grupo")
        ana.write("Tatus")
        ana.click("Entrar")
        ana.click("Empezar")
        for _ in range(3):
            ana.click("avanzar, 1, m")
        ana.click("Ejecutar")
        self.found["is_solved"] = ana.is_shown(_PASSED)
        self.photograph()

    def fail_to_update(self, program: "subprocess.Popen[str]") -> None:
        """Updates by a damaged package over the open PINEL, and with a full disk: the old version stays."""
        old, verify = version(), ("dpkg", "--verify", "pinel-desktop")
        self.found["damaged_said"] = refused("damaged", _CLOSED, _UNFINISHED)
        self.found["damaged_end"] = program.wait(_TIMEOUT_S)
        self.found["damaged_left"] = as_root(*verify) if version() == old else version()
        with full_disk():
            self.found["full_said"] = refused("newer", _UNFINISHED)
            self.found["full_left"] = as_root(*verify) if version() == old else version()

    def update(self) -> None:
        """Updates the open PINEL; the work is there again. An older stick changes nothing."""
        old, program = version(), self._open("drawn_before_update")
        self.found["update_status"], said = install("newer")
        self.found["update_said"] = _CLOSED in said
        self.found["update_end"] = program.wait(_TIMEOUT_S)
        new, program = version(), self._open("drawn_after_update")
        self.found["is_updated"] = new != old
        ana = pupil.Pupil(_USER, self._session)
        ana.click("Tatus")
        ana.find("Álbum")  # the last in the header: on a busy PC it pushes the next one aside
        ana.click("Nuestros trabajos")
        works = ("Abrir: Hasta la panadería", "Cumplió la misión Hasta la panadería")
        self.found["is_work_there"] = all(map(ana.is_shown, works))
        self.found["older_status"], _ = install("first")
        self.found["older_changes"] = version() != new or program.poll() is not None
        end(program)

    def meet_poor_systems(self) -> None:
        """Opens PINEL without D-Bus, without fonts, and with a home folder that cannot be written."""
        said = run("doctor", "--json", **self._bare).communicate(timeout=_TIMEOUT_S)[0]
        self.found["doctor"] = said[said.find("{") :]  # without the warnings of GTK
        with mounted("-t", "tmpfs", "tmpfs", "/usr/share/fonts"):
            end(self._open("drawn_without_fonts"))
        with mounted("--bind", str(_HOME), str(_HOME)):
            as_root("mount", "-o", "remount,bind,ro", str(_HOME))
            program = self._open("drawn_read_only")
            program.terminate()
            said = program.communicate(timeout=_TIMEOUT_S)[0]
            self.found["read_only_said"] = _READ_ONLY in said or said

    def smoke(self) -> None:
        """Runs the smoke test on the installed package, without D-Bus."""
        started = time.monotonic()
        home = Path("/home/teste")
        inputs = home / ".local" / "share" / "pinel" / "entradas"
        shutil.copytree(_STICKS / "inputs", inputs)
        for path in (home, *home.rglob("*")):
            os.chown(path, _USER, _USER)
        launcher = [*_LAUNCHER, f"HOME={home}", f"DISPLAY={self._bare['DISPLAY']}"]
        with contextlib.redirect_stdout(sys.stderr):
            self.found["smoke"] = smoke.faults_of_package(_PACKAGE, home, launcher, inputs)
        shutil.rmtree(home)
        self.found["smoke_s"] = round(time.monotonic() - started, 1)

    def remove(self) -> None:
        """Removes the package while PINEL is open, as in a lab; the work stays."""
        program = self._open("drawn_before_removal")
        command = ("apt-get", "-q", "-y", "remove", "pinel-desktop")
        self.found["remove_status"], self.found["remove"] = as_root(*command)
        self.found["end_status"] = program.wait(_TIMEOUT_S)
        self.found["is_gone"] = not (_PACKAGE.exists() or _AUTOSTART.exists())
        self.found["kept"] = sorted(path.name for path in _DATA.glob("*.db"))
        self.found["settings"] = (_DATA / "pinel.db.page.json").read_text("utf-8")
        self.found["files_outside"] = files_outside()

    def photograph(self) -> None:
        """Writes the picture of the screen."""
        self._screenshot.seek(0)
        self._screenshot.write(picture()[1])

    def _open(self, drawn: str) -> "subprocess.Popen[str]":
        """Opens PINEL and waits for its page; `drawn` is the name of the result."""
        program = run(**self._session)
        self.found[drawn] = is_drawn(program)
        return program


def install(stick: str) -> tuple[int, str]:
    """Installs from a stick as the technician does."""
    return as_root("sh", f"{_STICKS}/{stick}/instalar.sh")


def refused(stick: str, *texts: str) -> bool | str:
    """Returns True if a stick is not installed and the texts are said, else what is said."""
    status, said = install(stick)
    return (status == 1 and all(text in said for text in texts)) or f"{status}: {said}"


def version() -> str:
    """Returns the installed version, and that it is whole."""
    return as_root("dpkg-query", "-W", "-f", "${Status} ${Version}", "pinel-desktop")[1]


def end(program: "subprocess.Popen[str]") -> None:
    """Closes PINEL as the end of the session does."""
    program.terminate()
    program.wait(_TIMEOUT_S)


@contextlib.contextmanager
def mounted(*arguments: str) -> Iterator[None]:
    """Mounts something; the last argument is the folder."""
    subprocess.run(["mount", *arguments], env=_AS_ROOT, check=True)
    try:
        yield
    finally:
        subprocess.run(["umount", "--lazy", arguments[-1]], env=_AS_ROOT, check=True)


@contextlib.contextmanager
def full_disk() -> Iterator[None]:
    """Leaves 50 MB beside the installed program, on a disk of its own."""
    copy = _RUNTIME / "disk"
    copy.mkdir()
    size = sum(smoke.files_of(_PACKAGE).values()) + 50_000_000
    with mounted("-t", "tmpfs", "-o", f"mode=755,size={size}", "tmpfs", str(copy)):
        subprocess.run(["cp", "-a", f"{_PACKAGE}/.", str(copy)], env=_AS_ROOT, check=True)
        with mounted("--bind", str(copy), str(_PACKAGE)):
            yield


def files_outside() -> list[str]:
    """Returns the user's files that are neither PINEL's work nor a cache of the desktop's own libraries."""
    return [
        str(file)
        for file in _HOME.rglob("*")
        if not file.is_dir() and smoke.is_outside(file, _HOME)
    ]


def main() -> None:
    system, sticks, screenshot = map(Path, sys.argv[1:])
    pupil.prepare()
    with screenshot.open("wb") as file:
        enter(system, sticks)
        with screen() as display, session_bus() as bus:
            school = School(display, bus, file)
            try:
                program = school.install()
                school.solve()
                school.fail_to_update(program)
                school.update()
                school.meet_poor_systems()
                school.smoke()
                school.remove()
            except BaseException:
                school.photograph()
                print(json.dumps(school.found), file=sys.stderr)
                raise
    print(json.dumps(school.found))


if __name__ == "__main__":
    main()
