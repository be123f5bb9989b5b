"""Runs the package in older and newer Debian systems than the build system, without network, as an ordinary user.

    python packaging/systems.py [CODENAME...]    as root; without names all of SYSTEMS

debootstrap makes each system from the Debian mirror of this machine's apt. It gets the packages of debian-depends.txt
and a virtual screen. In it, in_system.py runs `pinel doctor`, `pinel --self-check` and `pinel`, whose page must be
drawn. The picture of that screen is written to build/systems/CODENAME.png.
"""

import json
import os
import platform
import shutil
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import cv2
import in_system  # beside this file, as smoke
import numpy as np
import smoke

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build" / "systems"
DEPENDS = ROOT / "packaging" / "debian-depends.txt"
SYSTEMS = ("bookworm", "trixie")
_VIRTUAL_SCREEN = "xvfb"
_NAMESPACES = ("unshare", "--mount", "--net", "--ipc", "--pid", "--fork", "--kill-child")
_BARE = (
    "/usr/bin/env",
    "-i",
    "PATH=/usr/sbin:/usr/bin:/sbin:/bin",
    "DEBIAN_FRONTEND=noninteractive",
)
_APT_GET = (
    *("apt-get", "-qq", "-y", "-o", "APT::Install-Recommends=false", "-o", "Dpkg::Use-Pty=0"),
    # no fsync, which is slow: the system is deleted after some minutes
    *("-o", "Dpkg::Options::=--force-unsafe-io"),
)


class NotPossibleError(Exception):
    """Systems cannot be made on this machine."""


def check_machine() -> None:
    """Raises NotPossibleError with the reason if no system can be made."""
    if sys.platform != "linux" or os.geteuid() != 0:
        raise NotPossibleError("only root on Linux may make another system and enter it")
    if shutil.which("debootstrap") is None:
        raise NotPossibleError(
            "debootstrap is not installed: sh scripts/system-packages.sh nightly"
        )
    if not sources("bookworm"):
        raise NotPossibleError("this machine's apt reads no mirror of Debian")


def sources(codename: str) -> list[tuple[str, str]]:
    """Returns address and suite of each Debian archive for a system, like the archives of this machine's apt."""
    form = ["--format", "$(REPO_URI) $(CODENAME)", "Created-By: Packages", "Origin: Debian"]
    done = subprocess.run(
        ["apt-get", "indextargets", *form], capture_output=True, text=True, check=True
    )
    own = platform.freedesktop_os_release().get("VERSION_CODENAME", "")
    lines = dict.fromkeys(line for line in done.stdout.splitlines() if " " in line)
    found = [(line.split()[0], line.split()[1]) for line in lines]
    suites = {own, f"{own}-updates", f"{own}-security"}
    return [
        (address, suite.replace(own, codename, 1)) for address, suite in found if suite in suites
    ]


def dependencies() -> str:
    """Returns the dependencies of the package as one line for apt."""
    lines = DEPENDS.read_text("utf-8").splitlines()
    return ", ".join(line for line in lines if line and not line.startswith("#"))


def make(codename: str) -> Path:
    """Makes a minimal system with the dependencies of the package; returns its folder."""
    system = FOLDER / codename
    shutil.rmtree(system, ignore_errors=True)
    system.with_suffix(".log").unlink(missing_ok=True)
    system.mkdir(parents=True)
    archives = sources(codename)
    mirror = next(address for address, suite in archives if suite == codename)
    _run(codename, "debootstrap", "--variant=minbase", codename, str(system), mirror)
    listed = "".join(f"deb {address} {suite} main\n" for address, suite in archives)
    (system / "etc" / "apt" / "sources.list").write_text(listed, "utf-8")
    for command in (
        ("update",),
        ("dist-upgrade",),
        ("satisfy", dependencies()),
        ("install", _VIRTUAL_SCREEN),
        ("clean",),
    ):
        inside = ("unshare", "--pid", "--fork", "--kill-child", "chroot", str(system))
        _run(codename, *inside, *_BARE, *_APT_GET, *command)
    return system


def _run(codename: str, *command: str) -> None:
    """Runs a step of making a system; writes its output to a log, and to the error if it fails."""
    log = (FOLDER / codename).with_suffix(".log")
    with log.open("a", encoding="utf-8") as output:
        done = subprocess.run(
            command, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT, check=False
        )
    if done.returncode:
        tail = "".join(log.read_text("utf-8").splitlines(keepends=True)[-20:])
        raise RuntimeError(f"{' '.join(command)}: status {done.returncode}\n{tail}")


def try_package(system: Path, package: Path = smoke.PACKAGE) -> dict[str, Any]:
    """Runs the package in a system; returns the results of in_system.py and saves the picture."""
    raw = system.with_suffix(".xwd")
    inside = [sys.executable, str(ROOT / "packaging" / "in_system.py")]
    done = subprocess.run(
        [*_NAMESPACES, *inside, str(system), str(package), str(raw)],
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
        + [f"doctor: {', '.join(window)}"] * (window != ["doctor_window_ok"])
        + ["the window stays empty"] * (found["n_colours"] < in_system.MIN_COLOURS)
    )


def report(codename: str) -> bool:
    """Makes a system, tries the package in it and prints the results; True if everything works."""
    started = time.monotonic()
    system = make(codename)
    size, made_s = _size_of(system), time.monotonic() - started
    found = try_package(system)
    shutil.rmtree(system)
    faults = faults_of(found)
    print(
        f"{codename}: {size / 1e6:.0f} MB, made in {made_s:.0f} s; self-check {found['check_s']} s"
    )
    print(f"{found['check']}\n{found['doctor']}")
    print(f"{codename}: {', '.join(faults) or 'the package works'}\n", flush=True)
    return not faults


def main() -> int:
    try:
        check_machine()
    except NotPossibleError as reason:
        sys.exit(f"Not tried: {reason}.")
    if not smoke.PACKAGE.is_dir():
        sys.exit("There is no package: run `make package` first.")
    results = [report(codename) for codename in sys.argv[1:] or SYSTEMS]
    return int(not all(results))


if __name__ == "__main__":
    sys.exit(main())
