"""The checksums of what is built, by the program that checks them."""

import subprocess
from pathlib import Path

from tests.packaging.loading import load

checksums = load("packaging/checksums.py")
VERSION = checksums.__version__


def checked(folder: Path) -> tuple[int, list[str]]:
    """Exit status of sha256sum, and the files that it checked."""
    command = ["sha256sum", "-c", "SHA256SUMS"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    return done.returncode, [line.partition(": ")[0] for line in done.stdout.splitlines()]


def test_all_that_is_built_of_this_version_is_listed(tmp_path: Path) -> None:
    built = [
        f"pinel-desktop-{VERSION}-setup.exe",
        f"pinel-desktop-{VERSION}-x86_64.tar.xz",
        f"pinel-desktop_{VERSION}_amd64.deb",
    ]
    others = ["pinel-desktop_0.0.1_amd64.deb", f"pinel_desktop-{VERSION}-py3-none-any.whl"]
    (tmp_path / "stick").mkdir()
    for name in (*built, *others, "stick/copy.deb"):
        (tmp_path / name).write_bytes(name.encode())
    for _ in range(2):
        checksums.update_dist(tmp_path)
        assert checked(tmp_path) == (0, built)
    (tmp_path / built[1]).write_bytes(b"damaged")
    assert checked(tmp_path)[0] == 1


def test_a_folder_is_listed_with_what_is_below_it_but_not_the_list_itself(tmp_path: Path) -> None:
    (tmp_path / "below").mkdir()
    for name in ("a", "below/b", "SHA256SUMS"):
        (tmp_path / name).write_text(name, "utf-8")
    checksums.write_checksums(tmp_path, [one for one in tmp_path.rglob("*") if one.is_file()])
    assert checked(tmp_path) == (0, ["a", "below/b"])
