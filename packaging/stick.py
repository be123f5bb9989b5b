"""Makes the folder for a USB stick, dist/stick: all that a PC without internet needs.

    python packaging/stick.py [CODENAME...]    as root; without names all of systems.SYSTEMS

It holds the package for Debian and Ubuntu, the portable version, instalar.sh, the installer for Windows if it was
built, and for each system a folder of the packages that a minimal installation of it lacks, for the kiosk session too.
SHA256SUMS lists all files.
"""

import shutil
import subprocess
import sys
from pathlib import Path

import checksums  # beside this file, as the next four
import deb
import nsis
import portable
import systems

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "dist" / "stick"
_TEXTS = ROOT / "packaging" / "stick"
# what a session that runs nothing but PINEL needs besides PINEL (docs/kiosk.md); so in instalar.sh
KIOSK = ("cage", "xwayland", "udiskie")


def begin(folder: Path = FOLDER) -> None:
    """Makes the folder anew, with everything but the packages of the systems and the checksums."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    built = [one for one in (nsis.installer_path(),) if one.is_file()]
    for file in (deb.deb_path(), portable.portable_path(), *built, *_TEXTS.iterdir()):
        shutil.copy(file, folder)
    write_index(folder)


def add_packages(codename: str, system: Path, folder: Path = FOLDER) -> None:
    """Adds the packages that a system lacks for the program and the kiosk session; apt downloads them in it."""
    package = system / "tmp" / deb.deb_path().name
    shutil.copy(deb.deb_path(), package)
    systems.run_inside(
        codename, system, "install", "--download-only", f"/tmp/{package.name}", *KIOSK
    )
    package.unlink()
    target = folder / codename
    target.mkdir()
    for found in (system / "var" / "cache" / "apt" / "archives").glob("*.deb"):
        shutil.move(found, target)
    write_index(target)


def write_index(folder: Path) -> None:
    """Writes the index of a folder of packages that apt reads."""
    done = subprocess.run(
        ["dpkg-scanpackages", "--multiversion", "."],
        cwd=folder,
        capture_output=True,
        text=True,
        check=True,
    )
    (folder / "Packages").write_text(done.stdout, "utf-8")


def write_checksums(folder: Path = FOLDER) -> None:
    """Writes SHA256SUMS of all files."""
    checksums.write_checksums(folder, (file for file in folder.rglob("*") if file.is_file()))


def main() -> None:
    try:
        systems.check_machine()
    except systems.NotPossibleError as reason:
        sys.exit(f"Not made: {reason}.")
    begin()
    for codename in sys.argv[1:] or systems.SYSTEMS:
        system = systems.make_minimal(codename)
        add_packages(codename, system)
        shutil.rmtree(system)
    write_checksums()
    for folder in sorted(path for path in (FOLDER, *FOLDER.iterdir()) if path.is_dir()):
        size = sum(file.stat().st_size for file in folder.rglob("*") if file.is_file())
        print(
            f"{folder.relative_to(ROOT)}: {len(list(folder.glob('*.deb')))} packages, {size / 1e6:.0f} MB"
        )


if __name__ == "__main__":
    main()
