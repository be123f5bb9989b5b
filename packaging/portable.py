"""Builds the portable version, dist/pinel-desktop-VERSION-MACHINE.tar.xz, from dist/pinel-desktop.

    python packaging/portable.py

It is the folder `PINEL` with the program, an empty folder for the work of the groups, and a text. The same sources give
the same bytes.
"""

import io
import lzma
import platform
import sys
import tarfile
from pathlib import Path

import checksums  # beside this file, as the next one
import freeze

from pinel_desktop import __version__
from pinel_desktop.paths import PORTABLE_DATA

ROOT = Path(__file__).resolve().parents[1]
_TOP = "PINEL"
_TEXT = "LEIA-ME.txt"


def portable_path() -> Path:
    """Returns the path of the built archive."""
    return ROOT / "dist" / f"pinel-desktop-{__version__}-{platform.machine()}.tar.xz"


def write_archive(target: Path, package: Path = freeze.FOLDER) -> None:
    """Writes the portable version of a package."""
    with (
        lzma.open(target, "wb", preset=6) as compressed,
        tarfile.open(fileobj=compressed, mode="w", format=tarfile.GNU_FORMAT) as archive,
    ):
        archive.addfile(_folder(_TOP))
        archive.addfile(_folder(f"{_TOP}/{PORTABLE_DATA}"))
        text = (ROOT / "packaging" / "portable.txt").read_bytes()
        info = _anonymous(tarfile.TarInfo(f"{_TOP}/{_TEXT}"))
        info.size = len(text)
        archive.addfile(info, io.BytesIO(text))
        for path in sorted(package.rglob("*")):
            name = f"{_TOP}/programa/{path.relative_to(package)}"
            archive.add(path, name, recursive=False, filter=_anonymous)


def _folder(name: str) -> tarfile.TarInfo:
    info = tarfile.TarInfo(name)
    info.type, info.mode = tarfile.DIRTYPE, 0o755
    return _anonymous(info)


def _anonymous(info: tarfile.TarInfo) -> tarfile.TarInfo:
    """Removes what depends on the machine: time, owner and group."""
    info.mtime = int(freeze.SAME_BYTES["SOURCE_DATE_EPOCH"])
    info.uid = info.gid = 0
    info.uname = info.gname = ""
    return info


def main() -> None:
    if not freeze.PROGRAM.is_file():
        sys.exit("There is no package: run `make package` first.")
    write_archive(portable_path())
    checksums.update_dist()
    size = portable_path().stat().st_size
    print(f"{portable_path().relative_to(ROOT)}: {size / 1e6:.0f} MB")


if __name__ == "__main__":
    main()
