"""Selects the contents of the package; used by pinel.spec."""

import json
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

Entry = tuple[str, str, str]  # name in the package, file, kind

DATA_FOLDERS = {
    "pinel_desktop/web/static": "pinel_desktop/web/static",
    "pinel_desktop/messages/catalogue": "pinel_desktop/messages/catalogue",
    "pinel_desktop/activities/catalogue": "pinel_desktop/activities/catalogue",
    "pinel_desktop/activities/example_catalogue": "pinel_desktop/activities/example_catalogue",
    "pinel_desktop/camera/recordings": "pinel_desktop/camera/recordings",
    "pinel_desktop/gestures/weights": "pinel_desktop/gestures/weights",
    # run by the Python of an installed ROS
    "pinel_desktop/links/ros2/node": "pinel_desktop/links/ros2/node",
    "sim/worlds": "sim/worlds",
    "LICENSE": ".",
}
# what is written about the parts of the finished package, by the script that writes it
PROVENANCE = {"notices.py": "THIRD-PARTY-NOTICES.txt", "sbom.py": "pinel-desktop.cdx.json"}
# The programs of the package on each system; True for one that has a console. On Windows a program with a console opens
# one beside its window, and a program without cannot print to it.
PROGRAMS = {
    "linux": {"pinel": True},
    "darwin": {"pinel": False},
    "win32": {"pinel": True, "pinel-desktop": False},
}
# `--self-check` prints the versions of these libraries, or they read their own metadata.
METADATA = ("pywebview", "flask", "werkzeug", "pydantic", "pymunk", "numpy", "sqlite-utils")

_PYTHON_EXTRAS = "tkinter _tkinter turtle idlelib lib2to3 ensurepip venv pydoc_data test pip setuptools pkg_resources"
# some build machines have these, and unused optional parts of libraries import them
_OPTIONAL = (
    "cryptography yaml rich pygments markdown_it IPython pandas scipy onnx tflite pygame pyglet "
    "pytest _pytest hypothesis mypy numpy.f2py numpy.testing numpy.distutils "
    "webview.platforms.android webview.platforms.cef pyarrow duckdb distributed dask matplotlib PIL"
)
_GPL = "readline"
EXCLUDED = [*_PYTHON_EXTRAS.split(), *_OPTIONAL.split(), *_GPL.split()]
# Analysing gi.repository would collect the whole desktop; gi loads the PC's libraries at import.
_GTK = (
    "Atk Gdk GdkPixbuf Gio GLib GModule GObject Gtk HarfBuzz JavaScriptCore Pango Soup WebKit2 cairo freetype2 xlib "
    "GIRepository Gst Keybinder IBus"
)
_OTHER_PLATFORMS = "cocoa winforms edgechromium mshtml win32 qt"
_OTHER_TOOLKITS = "qtpy PyQt5 PyQt6 PySide2 PySide6 clr clr_loader pythonnet"
EXCLUDED_ON_LINUX = [
    *(f"gi.repository.{name}" for name in _GTK.split()),
    *(f"webview.platforms.{name}" for name in _OTHER_PLATFORMS.split()),
    *_OTHER_TOOLKITS.split(),
]
_SYSTEM_FOLDERS = ("/usr/lib", "/lib", "/usr/lib64", "/lib64")
_LIBRARIES = Path(__file__).with_name("system-libraries.txt")


@dataclass(frozen=True)
class SystemLibrary:
    """A row of system-libraries.txt, the table of shared libraries of the building system."""

    stem: str
    ships: bool
    work: str
    licence: str


def system_libraries() -> list[SystemLibrary]:
    """Returns the rows of system-libraries.txt."""
    lines = _LIBRARIES.read_text("utf-8").splitlines()
    rows = [line.split("|") for line in lines if line and not line.startswith("#")]
    cells = [[cell.strip() for cell in (*row, "")] for row in rows]
    return [SystemLibrary(stem, where == "ships", *rest[:2]) for stem, where, *rest in cells]


def library_of(file: str) -> SystemLibrary | None:
    """Returns the row of a shared library, by its file's name; None if the table has none."""
    name = file.partition(".so")[0]
    return next((row for row in system_libraries() if _is_called(name, row.stem)), None)


def _is_called(name: str, stem: str) -> bool:
    """True if the name is the stem, with or without a version (libpython3.11); false for libzstd and libz."""
    return name == stem or name.startswith(f"{stem}.")


def without_shared(binaries: Iterable[Entry]) -> list[Entry]:
    """Removes the system's shared libraries that must not ship.

    Libraries of wheels stay: their file names are not in the table.
    """
    entries = [(entry, library_of(Path(entry[0]).name)) for entry in binaries]
    return [entry for entry, row in entries if row is None or row.ships]


def without_links(entries: Iterable[Entry]) -> list[Entry]:
    """Removes symbolic links to libraries in subfolders.

    Each wheel finds its own libraries without them, and the file system of a USB stick may have no links.
    """
    return [entry for entry in entries if entry[2] != "SYMLINK"]


def system_modules() -> list[str]:
    """Returns modules of the build machine outside the environment, to exclude; only gi ships."""
    environment = [Path(folder) for folder in sys.path if "site-packages" in folder]
    system = [Path(folder) for folder in sys.path if "dist-packages" in folder]
    ours = {entry.name.partition(".")[0] for folder in environment for entry in folder.glob("*")}
    theirs = {entry.name.partition(".")[0] for folder in system for entry in folder.glob("*")}
    return sorted(name for name in theirs - ours - {"gi"} if name.isidentifier())


def without_bytecode(data: Iterable[Entry]) -> list[Entry]:
    """Removes bytecode that Python left beside the data files: it contains names of folders of this machine."""
    return [entry for entry in data if "__pycache__" not in Path(entry[0]).parts]


def without_gtk(binaries: Iterable[Entry]) -> list[Entry]:
    """Removes the system libraries that only GTK's bindings need."""
    from PyInstaller.depend import bindepend  # noqa: PLC0415 - installed only where packages are built

    entries = list(binaries)
    by_file = {Path(file).resolve(): file for _, file, _ in entries}
    waiting = [file for name, file, _ in entries if _is_root(name, file)]
    needed: set[str] = set()
    while waiting:
        file = waiting.pop()
        if file in needed:
            continue
        needed.add(file)
        for _, found in bindepend.get_imports(file):
            if found and (known := by_file.get(Path(found).resolve())):
                waiting.append(known)
    return [entry for entry in entries if entry[1] in needed or entry[0].startswith("gi/")]


def _is_root(name: str, file: str) -> bool:
    """True if a binary ships even if no other one needs it: an extension module, or Python for the bootloader."""
    from_system = file.startswith(_SYSTEM_FOLDERS) and "/python3" not in file
    return name.startswith("libpython") or not (from_system or name.startswith("gi/"))


def missing_provenance(package: Path) -> list[str]:
    """Returns the files about the parts of the package that are missing or empty."""
    files = [package / name for name in PROVENANCE.values()]
    return [file.name for file in files if not file.is_file() or not file.stat().st_size]


def write_manifest(file: Path, analysis: Any) -> None:
    """Writes the packed modules and the origin of each binary, for the licence notices."""
    manifest = {
        "modules": sorted(name for name, _, _ in analysis.pure),
        "binaries": sorted([name, source] for name, source, _ in analysis.binaries),
    }
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(manifest, indent=1), "utf-8")
