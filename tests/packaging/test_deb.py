"""The package for Debian and Ubuntu, made of a small folder in place of the program."""

import subprocess
from pathlib import Path

import pytest

from tests.packaging.loading import load

deb = load("packaging/deb.py")


@pytest.fixture
def program(tmp_path: Path) -> Path:
    """A folder like dist/pinel-desktop, with permissions as they were by chance."""
    folder = tmp_path / "program"
    (folder / "_internal").mkdir(parents=True)
    (folder / "pinel").write_bytes(b"\x7fELF")
    (folder / "THIRD-PARTY-NOTICES.txt").write_text("notices", "utf-8")
    library = folder / "_internal" / "libpython3.11.so.1.0"
    library.write_bytes(b"\x7fELF")
    library.chmod(0o700)
    (folder / "_internal" / "libpython3.11.so").symlink_to(library.name)
    return folder


def built(program: Path, folder: Path) -> Path:
    """The package of a program, built in `folder`."""
    root = folder / "root"
    root.mkdir(parents=True)
    deb.lay_out(root, program)
    deb.write_control(root)
    deb.build(root, folder / "some.deb")
    return folder / "some.deb"


def listed(package: Path) -> dict[str, str]:
    """Permissions and owner of each file of a package, by its path."""
    done = subprocess.run(["dpkg-deb", "-c", package], capture_output=True, text=True, check=True)
    columns = [line.split(maxsplit=5) for line in done.stdout.splitlines()]
    return {column[5].removeprefix("."): f"{column[0]} {column[1]}" for column in columns}


def test_files_have_their_places_and_permissions(program: Path, tmp_path: Path) -> None:
    files = listed(built(program, tmp_path / "one"))
    assert files["/usr/lib/pinel-desktop/pinel"] == "-rwxr-xr-x root/root"
    library = "/usr/lib/pinel-desktop/_internal/libpython3.11.so.1.0"
    assert files[library] == "-rw-r--r-- root/root"
    assert "/usr/bin/pinel -> ../lib/pinel-desktop/pinel" in files
    for place in (
        "/usr/share/applications/pinel-desktop.desktop",
        "/usr/share/metainfo/pinel-desktop.metainfo.xml",
        "/usr/share/mime/packages/pinel-desktop.xml",
        "/usr/share/icons/hicolor/256x256/apps/pinel-desktop.png",
        "/usr/share/doc/pinel-desktop/copyright",
        "/usr/share/wayland-sessions/pinel-kiosk.desktop",
        "/usr/share/doc/pinel-desktop/examples/pinel-kiosk.service",
    ):
        assert files[place] == "-rw-r--r-- root/root"


def test_a_double_click_on_a_bundle_opens_it_with_pinel() -> None:
    entry = (deb.TEXTS / "pinel-desktop.desktop").read_text("utf-8").splitlines()
    types = (deb.TEXTS / "pinel-desktop.xml").read_text("utf-8")
    assert {"Exec=pinel %f", "MimeType=application/x-pinel;"} <= set(entry)
    assert 'type="application/x-pinel"' in types
    assert 'pattern="*.pinel"' in types


def test_the_same_program_gives_the_same_bytes(program: Path, tmp_path: Path) -> None:
    first, again = built(program, tmp_path / "one"), built(program, tmp_path / "again")
    assert first.read_bytes() == again.read_bytes()


def test_dependencies_name_the_libraries_of_the_pc(program: Path, tmp_path: Path) -> None:
    package = built(program, tmp_path / "one")
    done = subprocess.run(
        ["dpkg-deb", "-f", package, "Depends"], capture_output=True, text=True, check=True
    )
    assert "gir1.2-webkit2-4.1" in done.stdout
    assert "libssl3t64 | libssl3" in done.stdout


@pytest.mark.parametrize(
    ("language", "expected"),
    [("pt_BR.UTF-8", "continua na pasta"), ("fr_FR.UTF-8", "reste dans"), ("C", "stays in")],
)
def test_the_removal_says_where_the_work_is(language: str, expected: str) -> None:
    script = deb.TEXTS / "postrm"
    done = subprocess.run(
        ["sh", script, "remove"],
        env={"PATH": "/usr/bin:/bin", "LANG": language},
        capture_output=True,
        text=True,
        check=True,
    )
    assert expected in done.stdout
    assert ".local/share/pinel" in done.stdout
