"""Builds the installer for Windows, dist/pinel-desktop-VERSION-setup.exe, with NSIS.

    python packaging/nsis.py [FOLDER]    without FOLDER: dist/pinel-desktop

FOLDER is a package that packaging/freeze.py built on Windows. Debian's NSIS packs it, because NSIS for Windows usually
makes installers of 32 bits only. The same files give the same bytes.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import checksums  # beside this file, as the next three
import contents
import freeze
import icon

from pinel_desktop import __version__

ROOT = Path(__file__).resolve().parents[1]
SCRIPT = ROOT / "packaging" / "windows" / "pinel.nsi"
# pinel.nsi deletes these by name, because the folder may hold files of others
CONTENTS = (
    *contents.PROVENANCE.values(),
    "_internal",
    *(f"{name}.exe" for name in contents.PROGRAMS["win32"]),
)
_VERSION = re.compile(r"\d+\.\d+\.\d+")


class InstallerError(Exception):
    """The installer cannot be built; the text is the reason."""


def installer_path(version: str = __version__) -> Path:
    """Returns the path of the built installer."""
    return ROOT / "dist" / f"pinel-desktop-{version}-setup.exe"


def build(target: Path, package: Path = freeze.FOLDER, version: str = __version__) -> None:
    """Writes the installer of a package. Raises InstallerError."""
    _check(package, version)
    with tempfile.TemporaryDirectory(prefix="pinel-nsis-") as name:
        definitions = {
            "VERSION": version,
            "FOLDER": package.resolve(),
            "SIZE_KIB": -(-freeze.size_of(package) // 1024),
            "ICON": icon.write_icon(Path(name) / "pinel.ico"),
            "PICTURE": icon.write_side_picture(Path(name) / "side.bmp"),
            "OUTPUT": target.resolve(),
        }
        compile_script(SCRIPT, definitions)


def compile_script(script: Path, definitions: dict[str, object]) -> None:
    """Compiles a script of NSIS. Raises InstallerError with the output of makensis, also for a warning."""
    program = shutil.which("makensis")
    if program is None:
        raise InstallerError("makensis is not installed: apt install nsis")
    defined = [f"-D{name}={value}" for name, value in definitions.items()]
    done = subprocess.run(
        [program, "-V2", "-WX", "-INPUTCHARSET", "UTF8", *defined, str(script)],
        env=os.environ | freeze.SAME_BYTES,
        capture_output=True,
        text=True,
        encoding="utf-8",
        errors="replace",
        check=False,
    )
    if done.returncode:
        raise InstallerError(done.stdout + done.stderr)


def _check(package: Path, version: str) -> None:
    """Raises InstallerError for a folder or a version for which pinel.nsi was not written."""
    if not _VERSION.fullmatch(version):
        raise InstallerError(f"the version {version} does not consist of three numbers")
    found = sorted(path.name for path in package.iterdir()) if package.is_dir() else []
    if found != sorted(CONTENTS):
        raise InstallerError(
            f"{package} is no package for Windows: it has {', '.join(found) or 'nothing'}, "
            f"instead of {', '.join(CONTENTS)}"
        )


def main() -> None:
    package = Path(sys.argv[1]) if len(sys.argv) > 1 else freeze.FOLDER
    target = installer_path()
    target.parent.mkdir(exist_ok=True)
    try:
        build(target, package)
    except InstallerError as reason:
        sys.exit(f"No installer: {reason}.")
    checksums.update_dist()
    print(f"{target.relative_to(ROOT)}: {target.stat().st_size / 1e6:.0f} MB")


if __name__ == "__main__":
    main()
