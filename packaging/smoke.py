"""Smoke test of the package: in another folder, as an ordinary user, with an empty environment, without a network.

    python packaging/smoke.py [FOLDER]    with FOLDER: an installed package, which is tried where it lies

Checks the shared libraries of dist/pinel-desktop against system-libraries.txt. Copies the package to a folder whose
name has spaces and accents, runs `--self-check` there and checks the JSON output. Then its commands read the work of an
earlier release, export and merge it, and record runs, one of which is killed. At the end no process may be left, and no
file outside the data folder. Root switches to the user `nobody` in a network namespace with loopback only. An ordinary
user and Windows cannot do so, and the output reports this.
"""

import contextlib
import gzip
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import contents  # beside this file

ROOT = Path(__file__).resolve().parents[1]
PACKAGE = ROOT / "dist" / "pinel-desktop"
RELEASED = ROOT / "tests" / "compatibility" / "files"
SQUARE = ROOT / "tests" / "programs" / "square.json"
# of GTK, GStreamer, Mesa and fontconfig, which every program with a window writes
_CACHES = ("dconf", "fontconfig", "gstreamer-1.0", "gtk-3.0", "mesa_shader_cache")
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


def launcher_for(home: Path, inputs: Path) -> list[str]:
    """Returns what starts a program with an empty environment, as the user `nobody` if this one is root."""
    if sys.platform == "win32":
        return []
    bare = ["/usr/bin/env", "-i", f"HOME={home}", "LANG=pt_BR.UTF-8"]
    if os.geteuid() != 0:
        print("Not root: the check runs as this user, and the network is not cut off.")
        return bare
    for path in (home, inputs, *inputs.rglob("*")):
        os.chown(path, _NOBODY, _NOBODY)
    locked = ["unshare", "--net", "/usr/bin/python3", "-c", _LOCKED_UP, str(_NOBODY)]
    return [*locked, *bare]


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


def check_faults(program: Path, home: Path, launcher: Sequence[str]) -> list[str]:
    """Returns the faults that the self-check of a program finds."""
    done = _run(program, home, launcher, "--self-check")
    try:
        found = json.loads(done.stdout)
    except ValueError:
        return [f"no JSON (status {done.returncode}): {done.stdout} {done.stderr}"]
    print(json.dumps(found, ensure_ascii=False, indent=2))
    return faults_of(found) + [f"status {done.returncode}: {done.stderr}"] * bool(done.returncode)


def write_inputs(folder: Path) -> None:
    """Writes what `work_faults` needs: the work of an earlier release, its recorded hash, and a program."""
    for packed in (RELEASED / "database").rglob("*.gz"):
        file = folder / packed.relative_to(RELEASED).with_suffix("")
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(gzip.decompress(packed.read_bytes()))
    shutil.copy(RELEASED / "summary.json", folder)
    shutil.copy(SQUARE, folder)


def work_faults(program: Path, home: Path, launcher: Sequence[str], inputs: Path) -> list[str]:
    """Returns what fails with the work of an earlier release, its export and merge, and a run that is killed.

    `inputs` is the folder of `write_inputs`; the database in it is changed.
    """
    database, square = str(inputs / "database" / "pinel.db"), str(inputs / "square.json")

    def pinel(*arguments: str) -> list[Any]:
        done = _run(program, home, launcher, "--db", database, *arguments, "--json")
        return [json.loads(line) for line in done.stdout.splitlines()] or [{"error": done.stderr}]

    (exported,) = pinel("export", str(inputs))
    (merged,) = pinel("merge", "--db", str(inputs / "merged.db"), str(exported.get("path")))
    with _started(
        program, home, launcher, "--db", database, "run", square, "--pace=live"
    ) as killed:
        _wait_for(lambda: pinel("runs", "list")[0].get("state") == "running")
        killed.kill()
    with _started(program, home, launcher, "--db", database, "serve") as served:
        assert served.stdout is not None
        has_address = "http" in served.stdout.readline()
        served.terminate()
    (ran,) = pinel("run", square)
    states = [run.get("state") for run in pinel("runs", "list")[:2]]
    summary = json.loads((inputs / "summary.json").read_text("utf-8"))
    expected = summary["database"]["content_hash"]
    right = {
        f"the work of an earlier release: {exported}": exported.get("content_hash") == expected,
        f"export and merge: {merged}": merged.get("content_hash") == expected,
        f"start after a crash, status {served.returncode}": has_address and not served.returncode,
        f"a run after a crash: {ran}": ran.get("state") == "finished",
        f"a killed run, and the next one: {states}": states == ["finished", "failed"],
    }
    return [name for name, is_right in right.items() if not is_right]


def leftover_faults(package: Path, home: Path) -> list[str]:
    """Returns the processes of the package that still run, and the files in `home` outside the data folder."""
    running = []
    for file in Path("/proc").glob("[0-9]*/exe") if sys.platform == "linux" else ():
        with contextlib.suppress(OSError):  # ended meanwhile
            if package in file.readlink().parents:
                running.append(f"still runs: {file.parent.name}")
    files = (Path(file) for file in (files_of(home) if sys.platform == "linux" else ()))
    return running + [
        f"outside the data folder: {file}" for file in files if is_outside(file, home)
    ]


def is_outside(file: Path, home: Path) -> bool:
    """Whether a file in a home folder is neither PINEL's work nor a cache of the desktop's own libraries."""
    place = file.relative_to(home)
    is_cache = place.parts[0] == ".cache" and place.parts[1].startswith(_CACHES)
    return not (is_cache or Path(".local/share/pinel") in place.parents)


def faults_of_package(
    package: Path, home: Path, launcher: Sequence[str], inputs: Path
) -> list[str]:
    """Returns all faults of a package, whose programs `launcher` starts; `inputs` is the folder of `write_inputs`."""
    before, faults = files_of(package), []
    for program in programs_of(package):
        faults += check_faults(program, home, launcher)
    faults += work_faults(programs_of(package)[0], home, launcher, inputs)
    faults += ["own folder changed"] * (files_of(package) != before)
    return faults + leftover_faults(package, home)


def _run(
    program: Path, home: Path, launcher: Sequence[str], *arguments: str
) -> "subprocess.CompletedProcess[str]":
    return subprocess.run(
        [*launcher, str(program), *arguments],
        cwd=home,
        env=environment_for(home),
        capture_output=True,
        encoding="utf-8",
        timeout=_TIMEOUT_S,
        check=False,
    )


def _started(
    program: Path, home: Path, launcher: Sequence[str], *arguments: str
) -> "subprocess.Popen[str]":
    return subprocess.Popen(
        [*launcher, str(program), *arguments],
        cwd=home,
        env=environment_for(home),
        stdout=subprocess.PIPE,
        encoding="utf-8",
    )


def _wait_for(is_reached: Callable[[], bool]) -> None:
    deadline = time.monotonic() + _TIMEOUT_S
    while not is_reached() and time.monotonic() < deadline:
        time.sleep(0.1)


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
        home, inputs = folder / "casa", folder / "entradas"
        home.mkdir()
        write_inputs(inputs)
        started = time.monotonic()
        launcher = launcher_for(home, inputs)
        faults = faults_of_package(installed or copy_to(folder), home, launcher, inputs)
    if faults:
        sys.exit("\n".join(["The package does not work:", *faults]))
    print(f"The package works: smoke test in {time.monotonic() - started:.0f} s.")


if __name__ == "__main__":
    main()
