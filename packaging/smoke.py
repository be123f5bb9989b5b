"""Smoke test of the package: in another folder, as an ordinary user, with an empty environment, without a network.

    python packaging/smoke.py [FOLDER]    with FOLDER: an installed package, which is tried where it lies

Checks the shared libraries of dist/pinel-desktop against system-libraries.txt. Copies the package to a folder whose
name has spaces and accents, runs `--self-check` there and checks the JSON output. Root switches to the user `nobody` in
a network namespace with loopback only. An ordinary user and Windows cannot do so, and the output reports this.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import contents  # beside this file

ROOT = Path(__file__).resolve().parents[1]
PACKAGE = ROOT / "dist" / "pinel-desktop"
_NOBODY = 65534
_OF_WINDOWS = (
    "SYSTEMROOT",
    "SYSTEMDRIVE",
    "PROGRAMFILES",
    "PROGRAMFILES(X86)",
    "PROGRAMDATA",
    "PATH",
    "COMSPEC",
)
_BACKENDS = {"linux": "gtk", "win32": "edgechromium", "darwin": "cocoa"}
_TIMEOUT_S = 180
# as an ordinary user in a network namespace with loopback only
_LOCKED_UP = """
import fcntl, os, socket, struct, sys
with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
    request = struct.pack("16sh", b"lo", 0x1)  # the flag IFF_UP
    fcntl.ioctl(any_socket, 0x8914, request)   # SIOCSIFFLAGS
os.setgroups([]); os.setgid(int(sys.argv[1])); os.setuid(int(sys.argv[1]))
os.execv(sys.argv[2], sys.argv[2:])
"""


def copy_to(folder: Path) -> Path:
    """Copies the package; returns its folder."""
    target = folder / "Laboratório de Robótica 1" / "PINEL (cópia)"
    shutil.copytree(PACKAGE, target, symlinks=True)
    return target


def programs_of(package: Path) -> list[Path]:
    """Returns the programs of the package; on Windows with and without a console, whose processes differ."""
    ending = ".exe" if sys.platform == "win32" else ""
    return [package / f"{name}{ending}" for name in contents.PROGRAMS[sys.platform]]


def environment_for(home: Path) -> dict[str, str]:
    """Returns the environment of the self-check: what Windows itself needs, and its folders in `home`."""
    if sys.platform != "win32":
        return dict(os.environ)  # `command_for` empties it
    system = {name: os.environ[name] for name in _OF_WINDOWS if name in os.environ}
    return system | dict.fromkeys(
        ("USERPROFILE", "LOCALAPPDATA", "APPDATA", "TEMP", "TMP"), str(home)
    )


def command_for(program: Path, home: Path) -> list[str]:
    """Returns the command line of the self-check with an empty environment."""
    check = [str(program), "--self-check"]
    if sys.platform == "win32":
        return check
    bare = ["/usr/bin/env", "-i", f"HOME={home}", "LANG=pt_BR.UTF-8"]
    if os.geteuid() != 0:
        print("Not root: the check runs as this user, and the network is not cut off.")
        return [*bare, *check]
    os.chown(home, _NOBODY, _NOBODY)
    locked = ["unshare", "--net", "/usr/bin/python3", "-c", _LOCKED_UP, str(_NOBODY)]
    return [*locked, *bare, *check]


def library_faults(package: Path) -> list[str]:
    """Returns messages about the system's shared libraries that lie in the package and must not.

    Libraries of wheels lie in subfolders and have other file names. A library there is a fault only if the table names
    it.
    """
    faults = []
    for file in sorted(package.rglob("lib*.so*")):
        row = contents.library_of(file.name)
        place = file.relative_to(package)
        if row is not None and not row.ships:
            faults.append(f"{place} ships, and would take the place of the one that WebKit needs")
        elif file.is_symlink():
            faults.append(f"{place} is a link, and the file system of a USB stick may have none")
        elif row is None and file.parent.name == "_internal":
            faults.append(f"{place} ships, and packaging/system-libraries.txt does not name it")
    return faults


def faults_of(found: dict[str, Any], platform: str = sys.platform) -> list[str]:
    """Returns the names of the failed conditions in the JSON object that the program printed."""
    expected = {
        "ok": found.get("ok") is True,
        "window.backend": found.get("window", {}).get("backend") == _BACKENDS[platform],
        "window.ready_s": found.get("window", {}).get("ready_s", 0) > 0,
        "run.state": found.get("run", {}).get("state") == "finished",
        "run.closing_error_m": found.get("run", {}).get("closing_error_m", 1) <= 1e-4,
        "run.duration_s": found.get("run", {}).get("duration_s", 99) <= 17,
        "judged": found.get("judged") is True,
        "signs": found.get("signs") == ["B", "A"],
        # elsewhere there is no wheel of it, and Python's own SQLite is older
        "versions.sqlite": platform != "linux"
        or _is_current(found.get("versions", {}).get("sqlite", "0")),
        "store.telemetry_sha256": bool(found.get("store", {}).get("telemetry_sha256")),
    }
    return [name for name, right in expected.items() if not right]


def _is_current(sqlite: str) -> bool:
    """True for a SQLite without the WAL-reset bug; false means the system's SQLite was used (storage/sqlite.py)."""
    return tuple(int(part) for part in sqlite.split(".")) >= (3, 51, 3)


def files_of(folder: Path) -> dict[str, int]:
    """Returns the sizes in bytes of all files below a folder, by path."""
    return {str(file): file.stat().st_size for file in folder.rglob("*") if file.is_file()}


def try_program(program: Path, home: Path) -> None:
    """Runs the self-check of a program; ends this script with a message if it fails."""
    before = files_of(program.parent)
    started = time.monotonic()
    done = subprocess.run(
        command_for(program, home),
        cwd=home,
        env=environment_for(home),
        capture_output=True,
        encoding="utf-8",
        timeout=_TIMEOUT_S,
        check=False,
    )
    seconds = time.monotonic() - started
    try:
        found = json.loads(done.stdout)
    except ValueError:
        sys.exit(f"No JSON (status {done.returncode}):\n{done.stdout}\n{done.stderr}")
    print(json.dumps(found, ensure_ascii=False, indent=2))
    faults = (
        faults_of(found)
        + [f"status {done.returncode}"] * bool(done.returncode)
        + ["own folder changed"] * (files_of(program.parent) != before)
    )
    if faults:
        sys.exit(f"The package does not work: {', '.join(faults)}\n{done.stderr}")
    print(f"The package works: self-check of {program.name} in {seconds:.0f} s.")


def main() -> None:
    installed = Path(sys.argv[1]) if len(sys.argv) > 1 else None
    if not (installed or PACKAGE).is_dir():
        sys.exit("There is no package: run `make package` first.")
    if faults := library_faults(installed or PACKAGE):
        sys.exit("\n".join(["The package works on this system only:", *faults]))
    if missing := contents.missing_provenance(installed or PACKAGE):
        sys.exit(f"The package lacks {', '.join(missing)}: run `make package` again.")
    with tempfile.TemporaryDirectory(prefix="pinel-smoke-", ignore_cleanup_errors=True) as name:
        folder = Path(name)
        folder.chmod(0o755)
        home = folder / "casa"
        home.mkdir()
        for program in programs_of(installed or copy_to(folder)):
            try_program(program, home)


if __name__ == "__main__":
    main()
