"""Makes minimal Debian systems in folders of build/systems, with debootstrap, as root.

The packages come from the Debian mirror of this machine's apt.
"""

import os
import platform
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build" / "systems"
DEPENDS = ROOT / "packaging" / "debian-depends.txt"
SYSTEMS = ("bookworm", "trixie")
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


def make_minimal(codename: str) -> Path:
    """Makes a minimal system; returns its folder."""
    system = FOLDER / codename
    shutil.rmtree(system, ignore_errors=True)
    system.with_suffix(".log").unlink(missing_ok=True)
    system.mkdir(parents=True)
    archives = sources(codename)
    mirror = next(address for address, suite in archives if suite == codename)
    _run(codename, "debootstrap", "--variant=minbase", codename, str(system), mirror)
    listed = "".join(f"deb {address} {suite} main\n" for address, suite in archives)
    (system / "etc" / "apt" / "sources.list").write_text(listed, "utf-8")
    for command in ("update", "dist-upgrade", "clean"):
        run_inside(codename, system, command)
    return system


def run_inside(codename: str, system: Path, *command: str) -> None:
    """Runs apt-get in a system."""
    inside = ("unshare", "--pid", "--fork", "--kill-child", "chroot", str(system))
    _run(codename, *inside, *_BARE, *_APT_GET, *command)


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
