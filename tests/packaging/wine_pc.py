"""A Windows PC made by Wine, with installers of small programs in place of PINEL."""

import os
import re
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType

from tests.packaging.loading import load

nsis = load("packaging/nsis.py")

SOURCES = Path(__file__).with_name("windows")
WEBVIEW2_SETUP = "MicrosoftEdgeWebView2RuntimeInstallerX64.exe"
UNINSTALL = r"Software\Microsoft\Windows\CurrentVersion\Uninstall\PINEL"
APP_PATHS = r"Software\Microsoft\Windows\CurrentVersion\App Paths\pinel.exe"
BUNDLES = r"Software\Classes\.pinel"
BUNDLE_TYPE = r"Software\Classes\PINEL.Work"
_WEBVIEW2 = r"Microsoft\EdgeUpdate\Clients\{F3017226-FE2A-4295-8BDF-00C3A9A7E4C5}"
_NOTHING: Mapping[str, str] = MappingProxyType({})
_TIMEOUT_S = 60
_WAIT_S = 30.0


def write_package(folder: Path, *names: str) -> Path:
    """Writes a folder like a package for Windows; `names` are files of its `_internal`."""
    (folder / "_internal").mkdir(parents=True)
    nsis.compile_script(SOURCES / "program.nsi", {"OUTPUT": folder / "pinel.exe"})
    shutil.copy(folder / "pinel.exe", folder / "pinel-desktop.exe")
    for name in ("THIRD-PARTY-NOTICES.txt", "pinel-desktop.cdx.json"):
        (folder / name).write_text(name, "utf-8")
    for name in names:
        file = folder / "_internal" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(name, "utf-8")
    return folder


class WinePc:
    """A prefix of Wine. `stick` is a folder outside of it, for installers."""

    def __init__(self, folder: Path) -> None:
        self._prefix = folder / "prefix"
        self._drive = self._prefix / "drive_c"
        self.stick = folder / "PEN DRIVE" / "PINEL 1º ano"
        self._environment = os.environ | {
            "WINEPREFIX": str(self._prefix),
            "WINEDEBUG": "-all",
            # neither Gecko nor Mono is fetched, and no menu of this PC changes
            "WINEDLLOVERRIDES": "mscoree,mshtml=;winemenubuilder.exe=d",
            "DISPLAY": "",
        }
        self._prefix.mkdir()
        # the server waits for the next program, which starts faster so
        subprocess.run(["wineserver", "-p300"], env=self._environment, check=True)
        self._wine("wineboot", "-i")
        users = (self._drive / "users").iterdir()
        self._home = next(user for user in users if user.name != "Public")
        self._temp = self._home / "Temp"
        self._log = self._temp / "pinel-setup.log"

    def close(self) -> None:
        """Ends the processes of this PC."""
        subprocess.run(["wineserver", "-k"], env=self._environment, check=False)

    def clear(self) -> None:
        """Deletes what installers have left, and empties the stick. The system is Windows 10."""
        self.set_windows("win10")
        keys = (UNINSTALL, APP_PATHS, BUNDLES, BUNDLE_TYPE, rf"Software\{_WEBVIEW2}")
        roots = ("HKEY_CURRENT_USER", "HKEY_LOCAL_MACHINE")
        lines = [rf"[-{root}\{key}]" for root in roots for key in keys]
        file = self._drive / "clear.reg"
        file.write_text("\n".join(["REGEDIT4", *lines, ""]), "utf-8")
        self._wine("regedit", "/S", r"C:\clear.reg")
        folders = (self.program("CurrentUser"), self.program("AllUsers"), self.data, self.stick)
        for folder in folders:
            shutil.rmtree(folder, ignore_errors=True)
        for name in (self._log.name, "close-pinel", "pinel-is-open"):
            (self._temp / name).unlink(missing_ok=True)
        self.stick.mkdir(parents=True)

    def program(self, mode: str) -> Path:
        """Returns the folder of the program that is installed with `/CurrentUser` or `/AllUsers`."""
        if mode == "AllUsers":
            return self._drive / "Program Files" / "PINEL"
        return self._home / "AppData" / "Local" / "Programs" / "PINEL"

    @property
    def data(self) -> Path:
        """Folder with the work of the groups."""
        return self._home / "AppData" / "Local" / "pinel"

    def menu(self, mode: str) -> list[str]:
        """Returns the names of the entries in the Start menu."""
        home = self._drive / "ProgramData" if mode == "AllUsers" else self._home / "AppData/Roaming"
        folder = home / "Microsoft" / "Windows" / "Start Menu" / "Programs" / "PINEL"
        return sorted(entry.name for entry in folder.glob("*"))

    def build_installer(self, package: Path, version: str) -> None:
        """Puts an installer on the stick, in place of an earlier one."""
        nsis.build(self.stick / "pinel-setup.exe", package, version)

    def build_webview2(self) -> None:
        """Puts a small program in place of the installer of WebView2 on the stick."""
        nsis.compile_script(SOURCES / "webview2.nsi", {"OUTPUT": self.stick / WEBVIEW2_SETUP})

    def install(self, *options: str, environment: Mapping[str, str] = _NOTHING) -> int:
        """Runs the installer of the stick without a window; returns its exit status."""
        words = " ".join(options).split()  # NSIS wants the folder of /D without quotation marks
        return self._start(
            str(self.stick / "pinel-setup.exe"), "/S", *words, environment=environment
        )

    def uninstall(self, mode: str) -> None:
        """Runs the uninstaller in its folder without a window, and waits: it continues in another process."""
        folder = self.program(mode)
        self._start(str(folder / "uninstall.exe"), "/S", f"/{mode}", folder=folder)
        self._wait_until(lambda: self.message != "")

    def uninstall_status(self, mode: str) -> int:
        """Runs the uninstaller without a window in one process, which cannot delete itself; returns its exit status."""
        program = self.program(mode)
        place = "C:\\" + str(program.relative_to(self._drive)).replace("/", "\\")
        words = f"_?={place}".split()  # NSIS wants it without quotation marks
        return self._start(str(program / "uninstall.exe"), "/S", f"/{mode}", *words)

    def open_program(self, program: Path) -> "subprocess.Popen[bytes]":
        """Starts the program and waits until it runs; `close_program` ends it."""
        process = subprocess.Popen(["wine", str(program)], env=self._environment)
        self._wait_until((self._temp / "pinel-is-open").exists)
        return process

    def close_program(self, process: "subprocess.Popen[bytes]") -> None:
        """Ends the program in order."""
        (self._temp / "close-pinel").touch()
        process.wait(_WAIT_S)

    @property
    def message(self) -> str:
        """The installer's message, "" without one."""
        return self._log.read_text("utf-16").strip() if self._log.exists() else ""

    def value(self, root: str, key: str, name: str = "") -> str | None:
        """Returns a text or number of the registry, as `reg query` prints it; None if there is none."""
        which = ("/v", name) if name else ("/ve",)
        _, output = self._run("reg", "query", rf"{root}\{key}", *which)
        found = re.search(r" REG_(?:SZ|DWORD) +(.*)", output)
        return found[1].strip() if found else None

    def set_windows(self, version: str) -> None:
        """Chooses which Windows programs see, such as `win7`."""
        self._wine("reg", "add", r"HKCU\Software\Wine", "/v", "Version", "/d", version, "/f")

    def set_webview2(self, version: str, root: str = "HKCU") -> None:
        """Writes the version of WebView2 where its installer does."""
        parent = r"SOFTWARE\WOW6432Node" if root == "HKLM" else "Software"
        self._wine("reg", "add", rf"{root}\{parent}\{_WEBVIEW2}", "/v", "pv", "/d", version, "/f")

    def webview2(self) -> str | None:
        """Returns the version of WebView2 of this account."""
        return self.value("HKCU", rf"Software\{_WEBVIEW2}", "pv")

    def _wait_until(self, is_reached: Callable[[], bool]) -> None:
        deadline = time.monotonic() + _WAIT_S
        while not is_reached():
            assert time.monotonic() < deadline
            time.sleep(0.05)

    def _wine(self, *command: str) -> None:
        status, output = self._run(*command)
        assert status == 0, output

    def _start(
        self, *command: str, folder: Path | None = None, environment: Mapping[str, str] = _NOTHING
    ) -> int:
        self._log.unlink(missing_ok=True)
        return self._run(*command, folder=folder, environment=environment)[0]

    def _run(
        self, *command: str, folder: Path | None = None, environment: Mapping[str, str] = _NOTHING
    ) -> tuple[int, str]:
        """Runs a program; returns its exit status and its output."""
        # no pipe: processes that stay in the background would keep it open
        with tempfile.TemporaryFile() as output:
            done = subprocess.run(
                ["wine", *command],
                cwd=folder,
                env={**self._environment, **environment},
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=subprocess.STDOUT,
                timeout=_TIMEOUT_S,
                check=False,
            )
            output.seek(0)
            return done.returncode, output.read().decode(errors="replace")
