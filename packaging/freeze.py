"""Builds the package, dist/pinel-desktop, with licence notices and a bill of materials of all its third-party parts."""

import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import contents  # beside this file

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "dist" / "pinel-desktop"
PROGRAM = FOLDER / ("pinel.exe" if sys.platform == "win32" else "pinel")
# The same sources must give the same bytes; without these, base_library.zip has a set's random order.
SAME_BYTES = {"PYTHONHASHSEED": "1", "SOURCE_DATE_EPOCH": "315532800"}


def size_of(folder: Path) -> int:
    """Bytes of all files below a folder."""
    return sum(
        file.stat().st_size
        for file in folder.rglob("*")
        if file.is_file() and not file.is_symlink()
    )


def build() -> None:
    """Runs PyInstaller; prints its output only if it fails."""
    shutil.rmtree(FOLDER, ignore_errors=True)
    log = ROOT / "build" / "pyinstaller.log"
    log.parent.mkdir(exist_ok=True)
    options = [
        "--noconfirm",
        "--log-level=WARN",
        f"--distpath={FOLDER.parent}",
        f"--workpath={ROOT / 'build'}",
    ]
    command = [
        sys.executable,
        "-m",
        "PyInstaller",
        *options,
        str(ROOT / "packaging" / "pinel.spec"),
    ]
    with log.open("w", encoding="utf-8") as output:
        done = subprocess.run(
            command,
            cwd=ROOT,
            env=os.environ | SAME_BYTES,
            stdout=output,
            stderr=subprocess.STDOUT,
            check=False,
        )
    if done.returncode:
        sys.exit(f"{log.read_text('utf-8')}\nThe package was not built.")


def main() -> None:
    print("Building the package (about 1 minute)…", flush=True)
    started = time.monotonic()
    build()
    for script, file in contents.PROVENANCE.items():
        command = [sys.executable, str(ROOT / "packaging" / script), str(FOLDER / file)]
        if subprocess.run(command, cwd=ROOT, check=False).returncode:
            sys.exit("The package must not be given to anybody.")
    seconds = time.monotonic() - started
    print(f"dist/pinel-desktop: {size_of(FOLDER) / 1e6:.0f} MB, built in {seconds:.0f} s")


if __name__ == "__main__":
    main()
