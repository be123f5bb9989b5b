"""Installs the package from a stick in older and newer Debian systems than the build system, without network.

    python packaging/trial.py [CODENAME...]    as root; without names all of systems.SYSTEMS

Each system is minimal, with a virtual screen added. In it, in_system.py runs instalar.sh of dist/stick with a set-up
file, `pinel doctor`, `pinel --self-check` and `pinel`, which must draw its page in kiosk mode, and removes the package.
The picture of that screen is written to build/systems/CODENAME.png.
"""

import json
import shutil
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import cv2
import deb  # beside this file, as the next ones
import in_system
import numpy as np
import smoke
import stick
import systems

from pinel_desktop.school.teacher import pin_hash

ROOT = Path(__file__).resolve().parents[1]
_VIRTUAL_SCREEN = "xvfb"
_SETUP_FILE = """
language = "es"
class = "9º A"
level = 2
kiosk = true
at_login = true
pin_hash = "{pin_hash}"
"""
_NAMESPACES = ("unshare", "--mount", "--net", "--ipc", "--pid", "--fork", "--kill-child")


def try_package(system: Path, stick: Path) -> dict[str, Any]:
    """Installs, runs and removes the package in a system; returns the results and saves the picture."""
    raw = system.with_suffix(".xwd")
    inside = [sys.executable, str(ROOT / "packaging" / "in_system.py")]
    done = subprocess.run(
        [*_NAMESPACES, *inside, str(system), str(stick), str(raw)],
        stdout=subprocess.PIPE,
        text=True,
        check=True,
    )
    save_picture(raw.read_bytes(), system.with_suffix(".png"))
    raw.unlink()
    found: dict[str, Any] = json.loads(done.stdout)
    return found


def save_picture(dump: bytes, file: Path) -> None:
    """Writes a picture of a screen of 24 bits, in the format XWD, as PNG."""
    header = np.frombuffer(dump, ">u4", 25)
    height, row_bytes, n_entries = int(header[5]), int(header[12]), int(header[19])
    rows = np.frombuffer(dump, np.uint8, height * row_bytes, int(header[0]) + 12 * n_entries)
    cv2.imwrite(str(file), rows.reshape(height, -1, 4)[:, : int(header[4]), :3])


def _size_of(system: Path) -> int:
    return sum(file.lstat().st_size for file in system.rglob("*"))


def faults_of(found: dict[str, Any]) -> list[str]:
    """Returns messages about functions of the package that failed in a system."""
    try:
        check, findings = json.loads(found["check"]), json.loads(found["doctor"])["findings"]
    except ValueError:
        return ["the package does not start"]
    window = [finding["code"] for finding in findings if finding["about"] == "window"]
    faults: list[str] = smoke.faults_of(check)
    return (
        faults
        + [f"status {found['install_status']} of the installation"] * bool(found["install_status"])
        + [f"status {found['remove_status']} of the removal"] * bool(found["remove_status"])
        + ["the removal does not close the open program"] * (found["end_status"] != 0)
        + ["the removal leaves the program"] * (not found["is_gone"])
        + ["the removal deletes the work of the groups"] * (found["kept"] != ["pinel.db"])
        + [f"doctor: {', '.join(window)}"] * (window != ["doctor_window_ok"])
        + ["the set-up file is not used"] * ('"pinel_language": "es"' not in found["settings"])
        + ["the window is not in kiosk mode"] * (not found["is_kiosk"])
        + ["PINEL does not open at login"] * (not found["at_login"])
        + ["the window stays empty"] * (found["n_colours"] < in_system.MIN_COLOURS)
    )


def report(codename: str) -> bool:
    """Makes a system, tries the package in it and prints the results; True if everything works."""
    started = time.monotonic()
    system = systems.make_minimal(codename)
    stick.begin()
    stick.add_packages(codename, system)
    stick.write_checksums()
    # after the checksums, as a technician adds it
    (stick.FOLDER / "pinel.toml").write_text(
        _SETUP_FILE.format(pin_hash=pin_hash("314159")), "utf-8"
    )
    systems.run_inside(codename, system, "install", _VIRTUAL_SCREEN)
    size, made_s = _size_of(system), time.monotonic() - started
    found = try_package(system, stick.FOLDER)
    shutil.rmtree(system)
    (stick.FOLDER / "pinel.toml").unlink()
    faults = faults_of(found)
    print(
        f"{codename}: {size / 1e6:.0f} MB, made in {made_s:.0f} s; installed in {found['install_s']} s, "
        f"self-check {found['check_s']} s"
    )
    print(f"{found['install']}\n{found['check']}\n{found['doctor']}\n{found['remove']}")
    print(f"{codename}: {', '.join(faults) or 'the package works'}\n", flush=True)
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
