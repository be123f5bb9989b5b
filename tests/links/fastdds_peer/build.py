"""Builds the robot on Fast DDS, once for each state of its sources."""

import hashlib
import subprocess
from pathlib import Path

import pytest
from filelock import FileLock

HERE = Path(__file__).parent
ROOT = Path(__file__).resolve().parents[3]
BUILD = ROOT / "build" / "fastdds-peer"
INCLUDES = Path("/usr/include")
COMMAND = ("g++", "-std=c++14", "-O0", "-Wall", "-Wextra", "-Wno-unused-parameter")
LIBRARIES = ("-lfastrtps", "-lfastcdr", "-pthread")


def built_peer() -> Path:
    """The program. Skips the test on a system that has no Fast DDS 2; fails where set-up has not installed it."""
    BUILD.mkdir(parents=True, exist_ok=True)
    program = BUILD / f"peer-{_checksum(_library_version())}"
    with FileLock(BUILD / "lock"):
        if not program.exists():
            for old in BUILD.glob("peer-*"):
                old.unlink()
            made = BUILD / "making"
            subprocess.run([*COMMAND, "-o", made, HERE / "peer.cpp", *LIBRARIES], check=True)
            made.rename(program)
    return program


def _library_version() -> Path:
    """The header that tells the library's version."""
    for place in ("fastrtps/config.h", "*/fastrtps/config.h"):
        for header in INCLUDES.glob(place):
            return header
    dry_run = subprocess.run(
        ["sh", "scripts/system-packages.sh", "--dry-run", "test"],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert "libfastrtps-dev" not in dry_run.stdout, "run `make setup`: it installs Fast DDS"
    pytest.skip("this system has no package of Fast DDS 2: no DDS of somebody else to test with")


def _checksum(library_version: Path) -> str:
    """Of all that the program is made of."""
    files = (*sorted(HERE.glob("*.[ch]pp")), library_version)
    parts = [" ".join((*COMMAND, *LIBRARIES)).encode(), *(file.read_bytes() for file in files)]
    return hashlib.sha256(b"\0".join(parts)).hexdigest()[:16]
