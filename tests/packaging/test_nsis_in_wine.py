"""The installer for Windows in Wine, with a small program in place of PINEL: files, registry and messages."""

import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.packaging.wine_pc import (
    APP_PATHS,
    BUNDLE_TYPE,
    BUNDLES,
    UNINSTALL,
    WinePc,
    write_package,
)

pytestmark = [pytest.mark.nightly, pytest.mark.timeout(300)]
MODES = ("CurrentUser", "AllUsers")
ROOTS = {"CurrentUser": "HKCU", "AllUsers": "HKLM"}


@pytest.fixture(scope="module")
def prefix(tmp_path_factory: pytest.TempPathFactory) -> Iterator[WinePc]:
    if shutil.which("wine") is None:
        pytest.skip("wine is not installed: sh scripts/system-packages.sh nightly")
    pc = WinePc(tmp_path_factory.mktemp("wine"))
    yield pc
    pc.close()


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_package(
        tmp_path_factory.mktemp("package") / "pinel-desktop", "python.dll", "cv2/cv2.pyd"
    )


@pytest.fixture
def pc(prefix: WinePc, package: Path) -> WinePc:
    """A PC with WebView2, and a stick with the installer of 0.2.0."""
    prefix.clear()
    prefix.set_webview2("120.0.1.2")
    prefix.build_installer(package, "0.2.0")
    return prefix


def files_below(folder: Path) -> list[str]:
    return sorted(str(file.relative_to(folder)) for file in folder.rglob("*") if file.is_file())


INSTALLED = [
    "THIRD-PARTY-NOTICES.txt",
    "_internal/cv2/cv2.pyd",
    "_internal/python.dll",
    "pinel-desktop.cdx.json",
    "pinel-desktop.exe",
    "pinel.exe",
    "uninstall.exe",
]


@pytest.mark.parametrize("mode", MODES)
def test_an_installation_writes_files_menu_and_registry(pc: WinePc, mode: str) -> None:
    assert pc.install(f"/{mode}") == 0
    assert files_below(pc.program(mode)) == INSTALLED
    assert pc.menu(mode) == ["PINEL in the terminal.lnk", "PINEL.lnk"]
    root = ROOTS[mode]
    folder = pc.value(root, UNINSTALL, "InstallLocation")
    assert folder is not None
    assert folder.endswith(r"\PINEL")
    assert pc.value(root, UNINSTALL, "DisplayVersion") == "0.2.0"
    assert pc.value(root, UNINSTALL, "UninstallString") == rf'"{folder}\uninstall.exe" /{mode}'
    assert pc.value(root, APP_PATHS) == rf"{folder}\pinel.exe"
    assert pc.value(root, BUNDLES) == "PINEL.Work"
    command = pc.value(root, rf"{BUNDLE_TYPE}\shell\open\command")
    assert command == rf'"{folder}\pinel-desktop.exe" "%1"'
    assert pc.message == ""
    other = next(one for one in MODES if one != mode)
    assert not pc.program(other).exists()
    assert pc.value(ROOTS[other], UNINSTALL, "DisplayVersion") is None


@pytest.mark.parametrize("mode", MODES)
def test_the_uninstaller_keeps_the_work_and_says_where_it_is(pc: WinePc, mode: str) -> None:
    pc.install(f"/{mode}")
    pc.data.mkdir()
    (pc.data / "pinel.db").write_text("work", "utf-8")
    (pc.program(mode) / "notes.txt").write_text("of the teacher", "utf-8")
    pc.uninstall(mode)
    assert files_below(pc.data) == ["pinel.db"]
    assert files_below(pc.program(mode)) == ["notes.txt"]
    assert pc.menu(mode) == []
    for key in (UNINSTALL, APP_PATHS, BUNDLES, BUNDLE_TYPE):
        assert pc.value(ROOTS[mode], key) is None
    assert "The work of the groups stays in the folder" in pc.message
    assert pc.message.endswith(r"\AppData\Local\pinel.")


@pytest.mark.parametrize("mode", MODES)
def test_the_uninstaller_deletes_its_folder_if_nothing_of_others_is_in_it(
    pc: WinePc, mode: str
) -> None:
    pc.install(f"/{mode}")
    pc.uninstall(mode)
    assert not pc.program(mode).exists()


def test_the_uninstaller_of_one_mode_leaves_the_other(pc: WinePc) -> None:
    pc.install("/CurrentUser")
    pc.install("/AllUsers")
    pc.uninstall("CurrentUser")
    assert files_below(pc.program("AllUsers")) == INSTALLED
    assert pc.value("HKLM", UNINSTALL, "DisplayVersion") == "0.2.0"
    assert pc.value("HKCU", UNINSTALL, "DisplayVersion") is None


@pytest.mark.parametrize("mode", MODES)
def test_an_update_stays_in_its_mode_and_leaves_no_former_file(
    pc: WinePc, mode: str, tmp_path: Path
) -> None:
    pc.install(f"/{mode}")
    pc.build_installer(write_package(tmp_path / "newer", "python.dll"), "0.10.0")
    assert pc.install() == 0
    assert files_below(pc.program(mode)) == [one for one in INSTALLED if "cv2" not in one]
    assert pc.value(ROOTS[mode], UNINSTALL, "DisplayVersion") == "0.10.0"


def test_the_same_version_can_be_installed_again(pc: WinePc) -> None:
    pc.install("/AllUsers")
    (pc.program("AllUsers") / "_internal" / "python.dll").unlink()
    assert pc.install() == 0
    assert files_below(pc.program("AllUsers")) == INSTALLED


def test_an_older_version_is_refused(pc: WinePc, package: Path) -> None:
    pc.build_installer(package, "0.10.0")
    pc.install("/AllUsers")
    pc.build_installer(package, "0.9.9")
    assert pc.install() == 3
    assert "This PC already has PINEL 0.10.0, newer than 0.9.9." in pc.message
    assert files_below(pc.program("AllUsers")) == INSTALLED
    assert pc.value("HKLM", UNINSTALL, "DisplayVersion") == "0.10.0"


def test_a_windows_before_10_is_refused(pc: WinePc) -> None:
    pc.set_windows("win81")
    assert pc.install("/CurrentUser") == 6
    assert pc.message == "PINEL needs Windows 10 or a newer one. Nothing was installed."
    assert not pc.program("CurrentUser").exists()


@pytest.fixture
def opened(pc: WinePc, request: pytest.FixtureRequest) -> "Iterator[subprocess.Popen[bytes]]":
    """PINEL for all accounts, installed and open; the parameter is its program."""
    pc.install("/AllUsers")
    process = pc.open_program(pc.program("AllUsers") / request.param)
    yield process
    pc.close_program(process)


@pytest.mark.parametrize("opened", ["pinel-desktop.exe", "pinel.exe"], indirect=True)
def test_neither_update_nor_removal_touches_an_open_pinel(
    pc: WinePc, opened: "subprocess.Popen[bytes]", package: Path
) -> None:
    pc.build_installer(package, "0.3.0")
    assert pc.install() == 4
    assert pc.message.startswith("PINEL is open. Close it")
    assert pc.value("HKLM", UNINSTALL, "DisplayVersion") == "0.2.0"
    assert pc.uninstall_status("AllUsers") == 4
    assert pc.message.startswith("PINEL is open. Close it")
    assert files_below(pc.program("AllUsers")) == INSTALLED
    assert pc.value("HKLM", UNINSTALL, "DisplayVersion") == "0.2.0"
    pc.close_program(opened)
    assert pc.install() == 0
    assert pc.value("HKLM", UNINSTALL, "DisplayVersion") == "0.3.0"


def test_another_folder_is_used_and_an_update_finds_it(pc: WinePc, package: Path) -> None:
    folder = pc.program("AllUsers").with_name("Sala de aula")
    assert pc.install("/AllUsers", r"/D=C:\Program Files\Sala de aula") == 0
    assert files_below(folder) == INSTALLED
    pc.build_installer(package, "0.3.0")
    assert pc.install() == 0
    assert files_below(folder) == INSTALLED
    assert not pc.program("AllUsers").exists()
    assert pc.install(r"/D=C:\Program Files\PINEL") == 0
    assert files_below(pc.program("AllUsers")) == INSTALLED
    assert files_below(folder) == []


@pytest.mark.parametrize("version", ["", "0.0.0.0"])
def test_a_pc_without_webview2_gets_it_from_the_stick(pc: WinePc, version: str) -> None:
    pc.set_webview2(version)
    pc.build_webview2()
    assert pc.install("/CurrentUser") == 0
    assert pc.webview2() == "120.0.1.2"
    assert pc.message == ""


def test_a_webview2_for_all_accounts_counts(pc: WinePc) -> None:
    pc.set_webview2("")
    pc.set_webview2("119.0.0.1", root="HKLM")
    pc.build_webview2()
    assert pc.install("/CurrentUser") == 0
    pc.set_webview2("", root="HKLM")
    assert pc.webview2() == ""
    assert pc.message == ""


def test_a_pc_without_webview2_is_told_what_it_lacks(pc: WinePc) -> None:
    pc.set_webview2("")
    assert pc.install("/CurrentUser") == 0
    assert files_below(pc.program("CurrentUser")) == INSTALLED
    assert "this PC has no WebView2" in pc.message
    assert "put MicrosoftEdgeWebView2RuntimeInstallerX64.exe beside this installer" in pc.message


def test_the_set_up_file_is_copied_with_its_lesson_and_checked(pc: WinePc) -> None:
    (pc.stick / "pinel.toml").write_text('lesson = "aula.pinel"', "utf-8")
    (pc.stick / "aula.pinel").write_text("lesson", "utf-8")
    assert pc.install("/AllUsers") == 0
    assert files_below(pc.program("AllUsers") / "setup") == ["aula.pinel", "pinel.toml"]
    assert pc.message == ""


def test_an_update_replaces_the_set_up_file_or_keeps_it(pc: WinePc, package: Path) -> None:
    file = pc.program("AllUsers") / "setup" / "pinel.toml"
    (pc.stick / "pinel.toml").write_text("level = 1", "utf-8")
    pc.install("/AllUsers")
    (pc.stick / "pinel.toml").write_text("level = 2", "utf-8")
    pc.build_installer(package, "0.3.0")
    pc.install()
    assert file.read_text("utf-8") == "level = 2"
    (pc.stick / "pinel.toml").unlink()
    pc.install()
    assert file.read_text("utf-8") == "level = 2"
    pc.uninstall("AllUsers")
    assert not file.exists()


def test_a_set_up_file_with_faults_is_named(pc: WinePc) -> None:
    (pc.stick / "pinel.toml").write_text("wrong", "utf-8")
    assert pc.install("/CurrentUser") == 7
    assert files_below(pc.program("CurrentUser")) == [
        *INSTALLED[:-2],
        *("pinel.exe", "setup/pinel.toml", "uninstall.exe"),
    ]
    assert pc.message.startswith("PINEL is installed, but the file pinel.toml has errors.")


@pytest.mark.parametrize(
    ("language", "expected"),
    [
        ("pt_BR", "O PINEL está instalado, mas o arquivo pinel.toml tem erros."),
        ("pt_PT", "O PINEL está instalado, mas o arquivo pinel.toml tem erros."),
        ("es_AR", "PINEL está instalado, pero el archivo pinel.toml tiene errores."),
        ("fr_FR", "PINEL est installé, mais le fichier pinel.toml a des erreurs."),
        ("de_DE", "O PINEL está instalado, mas o arquivo pinel.toml tem erros."),
    ],
)
def test_the_installer_speaks_the_language_of_the_pc(
    pc: WinePc, tmp_path: Path, language: str, expected: str
) -> None:
    name = f"{language}.UTF-8"
    subprocess.run(["localedef", "-i", language, "-f", "UTF-8", tmp_path / name], check=True)
    (pc.stick / "pinel.toml").write_text("wrong", "utf-8")
    pc.install("/CurrentUser", environment={"LOCPATH": str(tmp_path), "LC_ALL": name})
    assert pc.message.startswith(expected)
