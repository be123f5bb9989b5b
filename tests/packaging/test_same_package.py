"""The same sources give the same package, byte for byte, wherever they lie."""

import hashlib
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.packaging.loading import ROOT

pytestmark = [pytest.mark.nightly, pytest.mark.timeout(1200)]
# git ignores them, and the package needs them
_BUILT = ("pinel_desktop/web/static", "pinel_desktop/gestures/weights")
_LIBRARIES = Path("ui") / "node_modules"


def sources_in(folder: Path) -> Path:
    """A copy of the sources as they are now, committed or not, with what set-up made for the package."""
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    for name in filter(None, listed.stdout.split("\0")):
        if (ROOT / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, folder / name)
    for name in _BUILT:
        shutil.copytree(ROOT / name, folder / name, symlinks=True, dirs_exist_ok=True)
    (folder / _LIBRARIES).symlink_to(ROOT / _LIBRARIES)
    return folder


def package_of(folder: Path) -> dict[str, str]:
    """Builds the package in a folder; returns the checksum of each of its files, or where it leads, by name."""
    subprocess.run([sys.executable, "packaging/freeze.py"], cwd=folder, check=True)
    package = folder / "dist" / "pinel-desktop"
    return {
        str(file.relative_to(package)): _content_of(file)
        for file in package.rglob("*")
        if file.is_symlink() or file.is_file()
    }


def _content_of(file: Path) -> str:
    if file.is_symlink():
        return f"-> {file.readlink()}"
    return f"{file.stat().st_mode & 0o111:o} {hashlib.sha256(file.read_bytes()).hexdigest()}"


def test_a_package_built_again_in_another_folder_is_the_same(tmp_path: Path) -> None:
    first = package_of(sources_in(tmp_path / "pinel"))
    again = package_of(sources_in(tmp_path / "Robótica 2026" / "cópia do pinel"))
    assert len(first) > 400
    assert {
        name for name in first.keys() | again.keys() if first.get(name) != again.get(name)
    } == set()
