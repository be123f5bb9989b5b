"""Tries the package as a school does, from the stick to the removal, in minimal Debian systems without network.

    python packaging/trial.py [CODENAME...]    as root; without names all of systems.SYSTEMS

Each system is minimal, with a virtual screen, D-Bus and AT-SPI added, which a desktop has. in_system.py installs there
from dist/stick with a set-up file and a lesson; a pupil solves the lesson's mission by clicks (pupil.py); a newer stick
updates the open PINEL, after a damaged stick and a full disk have failed to. strace records all addresses that any
process sends to. The picture of the solved mission, or of the first failure, is build/systems/CODENAME.png.
"""

import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import cv2
import deb  # beside this file, as the next ones
import numpy as np
import smoke
import stick
import systems

from pinel_desktop import __version__
from pinel_desktop.school.teacher import pin_hash
from storage import open_store
from storage.exchange.scope import Scope

ROOT = Path(__file__).resolve().parents[1]
STICKS = ROOT / "build" / "sticks"
_SCREEN = ("xvfb", "xdotool", "dbus-daemon", "at-spi2-core")
_SETUP_FILE = """
language = "es"
class = "9º A"
level = 2
lesson = "aula.pinel"
kiosk = true
at_login = true
pin_hash = "{pin_hash}"
"""
_NAMESPACES = ("unshare", "--mount", "--net", "--ipc", "--pid", "--fork", "--kill-child")
_SENDING = "connect,sendto,sendmsg,sendmmsg"
_ADDRESS = re.compile(r'inet_addr\("([^"]+)"|inet_pton\(AF_INET6, "([^"]+)"')
_LOOPBACK = re.compile(r"127\.|::1$|::ffff:127\.")
MAX_KIOSK_S = MAX_SMOKE_S = 180
# what in_system.py finds, in its order
_WHOLE = [0, ""]
EXPECTED = {
    "cut_said": True,
    "cut_left": False,
    "install_status": 0,
    "drawn": True,
    "is_kiosk": True,
    "at_login": True,
    "is_solved": True,
    "damaged_said": True,
    "damaged_end": 0,
    "damaged_left": _WHOLE,
    "full_said": True,
    "full_left": _WHOLE,
    "drawn_before_update": True,
    "update_status": 0,
    "update_said": True,
    "update_end": 0,
    "is_updated": True,
    "drawn_after_update": True,
    "is_work_there": True,
    "older_status": 0,
    "older_changes": False,
    "drawn_without_fonts": True,
    "drawn_read_only": True,
    "read_only_said": True,
    "smoke": [],
    "drawn_before_removal": True,
    "remove_status": 0,
    "end_status": 0,
    "is_gone": True,
    "kept": ["pinel.db"],
    "files_outside": [],
}


def make_sticks(folder: Path = STICKS) -> None:
    """Makes the sticks of a trial from dist/stick: first, newer, damaged, and one that was copied in part."""
    shutil.rmtree(folder, ignore_errors=True)
    first, newer, damaged, cut = (folder / name for name in ("first", "newer", "damaged", "cut"))
    shutil.copytree(stick.FOLDER, first, copy_function=os.link)
    # after the checksums, as a technician adds them
    (first / "pinel.toml").write_text(_SETUP_FILE.format(pin_hash=pin_hash("314159")), "utf-8")
    write_lesson(first / "aula.pinel")
    for copy in (newer, cut):
        shutil.copytree(first, copy, copy_function=os.link)
    _halve(cut / deb.deb_path().name)
    _seal(newer, make_newer(newer / deb.deb_path().name))
    shutil.copytree(newer, damaged, copy_function=os.link)
    _seal(damaged, _halve(next(damaged.glob("*.deb"))))
    smoke.write_inputs(folder / "inputs")


def write_lesson(file: Path) -> None:
    """Writes a lesson file of a class with the first mission."""
    teacher = file.with_name("teacher.db")
    with open_store(teacher) as store:
        classroom = store.classrooms.create("9º A")
        lesson = store.lessons.open(classroom.id, "Aula 1", "to_the_bakery")
        scope, computer = Scope(classroom.id, lesson_id=lesson.id), store.computers.this()
        store.exchange.export(file, app_version=__version__, computer=computer, scope=scope)
    for left in file.parent.glob("teacher.db*"):
        left.unlink()


def make_newer(package: Path) -> Path:
    """Replaces a package by one with the same files and a higher version; returns its path."""
    newer = package.with_name(package.name.replace(__version__, f"{__version__}.1"))
    package.rename(newer)
    parts = package.parent / "control"
    subprocess.run(["dpkg-deb", "--control", newer, parts], check=True)
    control = (parts / "control").read_text("utf-8")
    text = control.replace(f"Version: {__version__}", f"Version: {__version__}.1")
    (parts / "control").write_text(text, "utf-8")
    archive = package.parent / "control.tar.xz"
    subprocess.run(["tar", "-C", parts, "-cJf", archive, "."], check=True)
    shutil.copy(newer, package)  # the other sticks have the same file, by a link
    subprocess.run(["ar", "r", package, archive], check=True)
    package.replace(newer)
    archive.unlink()
    shutil.rmtree(parts)
    return newer


def _halve(package: Path) -> Path:
    content = package.read_bytes()
    package.unlink()
    package.write_bytes(content[: len(content) // 2])
    return package


def _seal(folder: Path, package: Path) -> None:
    """Writes index and checksums of a stick with another package; the checksums are of these two files only."""
    alone = folder / "alone"
    alone.mkdir()
    os.link(package, alone / package.name)
    stick.write_index(alone)
    (alone / "Packages").replace(folder / "Packages")
    shutil.rmtree(alone)
    checked = (package, folder / "Packages")
    lines = [f"{hashlib.sha256(one.read_bytes()).hexdigest()}  {one.name}\n" for one in checked]
    (folder / "SHA256SUMS").unlink()
    (folder / "SHA256SUMS").write_text("".join(lines), "utf-8")


def try_package(system: Path) -> dict[str, Any]:
    """Tries the package in a system; returns the results and saves the picture."""
    raw, sent = system.with_suffix(".xwd"), system.with_suffix(".strace")
    inside = [sys.executable, str(ROOT / "packaging" / "in_system.py")]
    traced = ("strace", "-f", "--seccomp-bpf", "-qq", "-e", f"trace={_SENDING}", "-o", str(sent))
    done = subprocess.run(
        [*_NAMESPACES, *traced, *inside, str(system), str(STICKS), str(raw)],
        stdout=subprocess.PIPE,
        text=True,
        check=False,
    )
    if raw.stat().st_size:
        save_picture(raw.read_bytes(), system.with_suffix(".png"))
    raw.unlink()
    done.check_returncode()
    found: dict[str, Any] = json.loads(done.stdout)
    return found | {"sent_to": strangers(sent.read_text("utf-8"))}


def strangers(trace: str) -> list[str]:
    """Returns the addresses off loopback in the output of strace."""
    found = {"".join(parts) for parts in _ADDRESS.findall(trace)}
    return sorted(address for address in found if not _LOOPBACK.match(address))


def save_picture(dump: bytes, file: Path) -> None:
    """Writes a picture of a screen of 24 bits, in the format XWD, as PNG."""
    header = np.frombuffer(dump, ">u4", 25)
    height, row_bytes, n_entries = int(header[5]), int(header[12]), int(header[19])
    rows = np.frombuffer(dump, np.uint8, height * row_bytes, int(header[0]) + 12 * n_entries)
    cv2.imwrite(str(file), rows.reshape(height, -1, 4)[:, : int(header[4]), :3])


def _size_of(system: Path) -> int:
    return sum(file.lstat().st_size for file in system.rglob("*"))


def faults_of(found: dict[str, Any]) -> list[str]:
    """Returns what is not as expected."""
    try:
        findings = json.loads(found["doctor"])["findings"]
    except ValueError:
        return [f"the doctor: {found['doctor']}"]
    window = [finding["code"] for finding in findings if finding["about"] == "window"]
    limits = {"kiosk_s": MAX_KIOSK_S, "smoke_s": MAX_SMOKE_S}
    return (
        [f"{name}: {found[name]}" for name, right in EXPECTED.items() if found[name] != right]
        + [f"{name}: {found[name]}" for name, limit in limits.items() if found[name] > limit]
        + [f"doctor: {', '.join(window)}"] * (window != ["doctor_window_ok"])
        + ["the set-up file is not used"] * ('"pinel_language": "es"' not in found["settings"])
        + [f"sent to {address}" for address in found["sent_to"]]
    )


def report(codename: str) -> bool:
    """Makes a system, tries the package in it and prints the results; True if everything works."""
    started = time.monotonic()
    system = systems.make_minimal(codename)
    stick.begin()
    stick.add_packages(codename, system)
    stick.write_checksums()
    make_sticks()
    systems.run_inside(codename, system, "install", *_SCREEN)
    size, made_s = _size_of(system), time.monotonic() - started
    found = try_package(system)
    shutil.rmtree(system)
    shutil.rmtree(STICKS)
    faults = faults_of(found)
    print(f"{codename}: {size / 1e6:.0f} MB, made in {made_s:.0f} s; {found['install']}")
    print(json.dumps(found, ensure_ascii=False, indent=1))
    print(
        f"{codename}: installed in {found['install_s']} s, kiosk after {found['kiosk_s']} s, "
        f"smoke test {found['smoke_s']} s: {', '.join(faults) or 'the package works'}\n",
        flush=True,
    )
    return not faults


def main() -> int:
    try:
        systems.check_machine()
    except systems.NotPossibleError as reason:
        sys.exit(f"Not tried: {reason}.")
    if not deb.deb_path().is_file():
        sys.exit("There is no package: run `make deb portable` first.")
    results = [report(codename) for codename in sys.argv[1:] or systems.SYSTEMS]
    return int(not all(results))


if __name__ == "__main__":
    sys.exit(main())
