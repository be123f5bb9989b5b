"""SHA256SUMS, which `sha256sum -c SHA256SUMS` checks: of the stick (stick.py), and of what is built into dist."""

import hashlib
from collections.abc import Iterable
from pathlib import Path

from pinel_desktop import __version__

DIST = Path(__file__).resolve().parents[1] / "dist"
_NAME = "SHA256SUMS"
_BUILT = (".deb", ".tar.xz", ".exe")


def write_checksums(folder: Path, files: Iterable[Path]) -> None:
    """Writes SHA256SUMS of files in a folder, or in folders below it."""
    listed = sorted(file for file in files if file.name != _NAME)
    lines = [f"{_checksum(file)}  {file.relative_to(folder)}\n" for file in listed]
    (folder / _NAME).write_text("".join(lines), "utf-8")


def update_dist(dist: Path = DIST) -> None:
    """Writes dist/SHA256SUMS of this version's `.deb`, portable version and installer for Windows, as far as built."""
    found = (file for file in dist.glob(f"*{__version__}*") if file.name.endswith(_BUILT))
    write_checksums(dist, found)


def _checksum(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()
