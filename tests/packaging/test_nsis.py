"""The installer for Windows, compiled from a small folder. (test_nsis_in_wine.py runs it.)"""

import re
import struct
from pathlib import Path

import pytest

from tests.packaging.loading import load

nsis = load("packaging/nsis.py")

TEXTS = (nsis.SCRIPT.parent / "texts.nsh").read_text("utf-8")


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A folder like dist/pinel-desktop on Windows."""
    folder = tmp_path / "pinel-desktop"
    (folder / "_internal" / "cv2").mkdir(parents=True)
    files = [name for name in nsis.CONTENTS if name != "_internal"]
    for name in (*files, "_internal/cv2/cv2.pyd"):
        (folder / name).write_text(name, "utf-8")
    return folder


def built(package: Path, target: Path) -> bytes:
    nsis.build(target, package, "0.2.0")
    return target.read_bytes()


def test_the_installer_is_a_program_of_64_bits_with_a_window(package: Path, tmp_path: Path) -> None:
    program = built(package, tmp_path / "pinel-setup.exe")
    assert program[:2] == b"MZ"
    (start,) = struct.unpack_from("<I", program, 0x3C)
    assert program[start : start + 4] == b"PE\0\0"
    machine, subsystem = struct.unpack_from("<4xH86xH", program, start)
    assert machine == 0x8664
    assert subsystem == 2
    assert b'level="highestAvailable"' in program


def test_the_same_package_gives_the_same_bytes(package: Path, tmp_path: Path) -> None:
    first = built(package, tmp_path / "one-setup.exe")
    (package / "pinel.exe").touch()
    assert built(package, tmp_path / "again-setup.exe") == first


def test_a_package_of_another_system_is_refused(package: Path, tmp_path: Path) -> None:
    (package / "pinel-desktop.exe").unlink()
    (package / "pinel.exe").rename(package / "pinel")
    with pytest.raises(nsis.InstallerError, match="no package for Windows: it has THIRD-PARTY"):
        built(package, tmp_path / "pinel-setup.exe")
    with pytest.raises(nsis.InstallerError, match="it has nothing"):
        built(tmp_path / "nowhere", tmp_path / "pinel-setup.exe")


def test_a_file_that_the_uninstaller_would_leave_is_refused(package: Path, tmp_path: Path) -> None:
    (package / "readme.txt").write_text("text", "utf-8")
    with pytest.raises(nsis.InstallerError, match=r"readme\.txt"):
        built(package, tmp_path / "pinel-setup.exe")


@pytest.mark.parametrize("name", nsis.CONTENTS)
def test_the_script_deletes_all_that_it_installs(name: str) -> None:
    removal = nsis.SCRIPT.read_text("utf-8").partition("!macro RemoveProgram")[2]
    assert f"\\{name}" in removal.partition("!macroend")[0]


@pytest.mark.parametrize("version", ["0.3", "0.3.0.dev1", "0.3.0a1"])
def test_a_version_that_cannot_be_compared_is_refused(
    package: Path, tmp_path: Path, version: str
) -> None:
    with pytest.raises(nsis.InstallerError, match="three numbers"):
        nsis.build(tmp_path / "pinel-setup.exe", package, version)


def test_a_warning_of_the_compiler_is_a_fault(tmp_path: Path) -> None:
    script = tmp_path / "some.nsi"
    script.write_text(
        f'OutFile "{tmp_path}/some-setup.exe"\nVar Unused\nSection\nSectionEnd', "utf-8"
    )
    with pytest.raises(nsis.InstallerError, match="Unused"):
        nsis.compile_script(script, {})


def test_each_text_has_four_languages() -> None:
    found = re.findall(r"^LangString (\w+) \$\{LANG_(\w+)\} \"(.+)\"$", TEXTS, re.M)
    texts = {name: [language for one, language, _ in found if one == name] for name, _, _ in found}
    assert len(texts) > 5
    for name, languages in texts.items():
        assert languages == ["PORTUGUESEBR", "ENGLISH", "SPANISH", "FRENCH"], name
