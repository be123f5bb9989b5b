"""Builds the package for Debian and Ubuntu, dist/pinel-desktop_VERSION_ARCHITECTURE.deb, from dist/pinel-desktop.

    python packaging/deb.py

Needs dpkg-deb. The same sources give the same bytes.
"""

import gzip
import hashlib
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import checksums  # beside this file, as the next two
import freeze
import systems

from pinel_desktop import __version__

ROOT = Path(__file__).resolve().parents[1]
TEXTS = ROOT / "packaging" / "debian"
NAME = "pinel-desktop"
_PROGRAM = Path("usr/lib") / NAME
_DOCS = Path("usr/share/doc") / NAME
_PLACES = {
    "pinel-desktop.desktop": "usr/share/applications",
    "pinel-desktop.metainfo.xml": "usr/share/metainfo",
    "pinel-desktop.xml": "usr/share/mime/packages",
    "pinel-kiosk.desktop": "usr/share/wayland-sessions",
    "pinel-kiosk.service": "usr/share/doc/pinel-desktop/examples",
}
_CONTROL = """\
Package: {name}
Version: {version}
Architecture: {architecture}
Maintainer: PINEL Desktop contributors <pinel-desktop@localhost>
Installed-Size: {size_kib}
Depends: {depends}
Suggests: cage, udiskie
Section: education
Priority: optional
Description: block programs drive a robot in the classroom
 Groups of pupils build programs of blocks, which drive a Pioneer 3-DX in a
 simulator, or a real robot over ROS 2. Signs of Libras, the Brazilian Sign
 Language, seen by the webcam decide what the robot does. The teacher reviews
 every program and every run after the lesson. Nothing needs the internet.
"""
_COPYRIGHT = """\
Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: PINEL Desktop
Comment: Licences of all other parts: THIRD-PARTY-NOTICES.txt beside this file.

Files: *
Copyright: 2026 PINEL Desktop contributors
License: Expat
{licence}"""


def lay_out(root: Path, package: Path = freeze.FOLDER) -> None:
    """Writes all files of the package below `root`, as they are on the PC, with their permissions."""
    shutil.copytree(package, root / _PROGRAM, symlinks=True)
    _link(root / "usr/bin/pinel", f"../lib/{NAME}/pinel")
    for name, folder in _PLACES.items():
        _copy(TEXTS / name, root / folder / name)
    _copy(
        ROOT / "ui" / "public" / "icon.png",
        root / "usr/share/icons/hicolor/256x256/apps" / f"{NAME}.png",
    )
    _copy(TEXTS / "lintian-overrides", root / "usr/share/lintian/overrides" / NAME)
    _compress(TEXTS / "pinel.1", root / "usr/share/man/man1/pinel.1.gz")
    _compress(ROOT / "CHANGELOG.md", root / _DOCS / "changelog.gz")
    _write(root / _DOCS / "copyright", _COPYRIGHT.format(licence=_licence()))
    shutil.move(root / _PROGRAM / "THIRD-PARTY-NOTICES.txt", root / _DOCS)
    _link(
        root / _PROGRAM / "THIRD-PARTY-NOTICES.txt",
        f"../../share/doc/{NAME}/THIRD-PARTY-NOTICES.txt",
    )
    _set_permissions(root)


def write_control(root: Path) -> None:
    """Writes the control files of the package whose files are below `root`."""
    folder = root / "DEBIAN"
    size = freeze.size_of(root)
    checksums = [
        f"{hashlib.md5(file.read_bytes(), usedforsecurity=False).hexdigest()}  {file.relative_to(root)}\n"
        for file in sorted(root.rglob("*"))
        if file.is_file() and not file.is_symlink()
    ]
    fields = {
        "name": NAME,
        "version": __version__,
        "architecture": architecture(),
        "size_kib": -(-size // 1024),
        "depends": systems.dependencies(),
    }
    _write(folder / "control", _CONTROL.format(**fields))
    _write(folder / "md5sums", "".join(checksums))
    folder.chmod(0o755)
    for name in ("prerm", "postrm"):
        _copy(TEXTS / name, folder / name)
        (folder / name).chmod(0o755)


def build(root: Path, target: Path) -> None:
    """Packs the files below `root` into a package."""
    # lintian of Debian 12 cannot read zstd
    command = ["dpkg-deb", "--root-owner-group", "-Zxz", "--build", str(root), str(target)]
    subprocess.run(
        command, env=os.environ | freeze.SAME_BYTES, stdout=subprocess.DEVNULL, check=True
    )


def architecture() -> str:
    """Returns dpkg's name of this machine's architecture."""
    done = subprocess.run(
        ["dpkg", "--print-architecture"], capture_output=True, text=True, check=True
    )
    return done.stdout.strip()


def deb_path() -> Path:
    """Returns the path of the built package."""
    return ROOT / "dist" / f"{NAME}_{__version__}_{architecture()}.deb"


def _licence() -> str:
    """Returns the licence in the form of a Debian copyright file: indented, a full stop for an empty line."""
    text = (ROOT / "LICENSE").read_text("utf-8").split("\n\n", 2)[2]
    return "".join(f" {line}".rstrip() + "\n" if line else " .\n" for line in text.splitlines())


def _set_permissions(root: Path) -> None:
    """Folders 0755; files 0644, the program 0755."""
    for path in [root, *root.rglob("*")]:
        if not path.is_symlink():
            is_program = path.is_dir() or path == root / _PROGRAM / "pinel"
            path.chmod(0o755 if is_program else 0o644)


def _copy(source: Path, target: Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(source, target)


def _write(target: Path, text: str) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(text, "utf-8")


def _link(target: Path, leads_to: str) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    target.symlink_to(leads_to)


def _compress(source: Path, target: Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_bytes(gzip.compress(source.read_bytes(), 9, mtime=0))


def main() -> None:
    if not freeze.PROGRAM.is_file():
        sys.exit("There is no package: run `make package` first.")
    with tempfile.TemporaryDirectory(prefix="pinel-deb-") as name:
        root = Path(name) / NAME
        root.mkdir()
        lay_out(root)
        write_control(root)
        build(root, deb_path())
    checksums.update_dist()
    print(f"{deb_path().relative_to(ROOT)}: {deb_path().stat().st_size / 1e6:.0f} MB")


if __name__ == "__main__":
    main()
