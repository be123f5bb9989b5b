"""Licence notices of all third-party parts of the package; refuses GPL and AGPL.

Sources: metadata of the Python distributions, npm packages of the page (ui/package-lock.json), shared libraries of the
system, whose licences system-libraries.txt lists because system packages do not state them per file, and networks and
training data of the gesture recognition.
"""

import json
import re
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path, PureWindowsPath
from typing import Any

import contents  # beside this file

_TEXTS = re.compile(r"(^|/)(licen[cs]e|copying|notice|authors)[^/]*$", re.IGNORECASE)
_FORBIDDEN = re.compile(r"(?<![A-Z])A?GPL|GNU (AFFERO )?GENERAL PUBLIC")
# A dependency of Blockly for use without a browser; not in the page.
NOT_IN_THE_PAGE = ("jsdom",)
# Distributions whose metadata names no licence; their licence text is in their folder.
UNNAMED_LICENCES = {"pysqlite3": "Zlib; SQLite in it: blessing (public domain)"}
MEDIAPIPE = "MediaPipe hand networks (palm_detection_full, hand_landmark_full)"
# Libraries that come with Python on Windows, by the beginning of their file names: work and licence.
WINDOWS_LIBRARIES = {
    "python3": ("Python", "PSF-2.0"),
    "libcrypto": ("OpenSSL", "Apache-2.0"),
    "libssl": ("OpenSSL", "Apache-2.0"),
    "libffi": ("libffi", "MIT"),
    "sqlite3": ("SQLite", "blessing (public domain)"),
    "vcruntime": (
        "Microsoft Visual C++ runtime",
        "Microsoft Software License Terms, redistributable",
    ),
    "msvcp": ("Microsoft Visual C++ runtime", "Microsoft Software License Terms, redistributable"),
    "ucrtbase": (
        "Microsoft Universal C runtime",
        "Microsoft Software License Terms, redistributable",
    ),
    "api-ms-win": (
        "Microsoft Universal C runtime",
        "Microsoft Software License Terms, redistributable",
    ),
    "microsoft.web.webview2": ("Microsoft Edge WebView2 SDK", "BSD-3-Clause"),
}
LIBRAS = (
    "Alfabeto em libras (data set of elainesilva on Roboflow Universe, version 6, 2023-08-15; the letters were learnt "
    "from it, no picture of it ships; https://creativecommons.org/licenses/by/4.0/)"
)


@dataclass(frozen=True, order=True)
class Notice:
    """Licence notice of one third-party part.

    Attributes:
        manager: package manager that installed it, as package URLs name it ("pypi", "npm"); "" for none.
    """

    name: str
    version: str
    licence: str
    texts: tuple[str, ...] = ()
    manager: str = ""


class LicenceError(Exception):
    """A part that must not ship, or whose licence is unknown."""


def parts(root: Path) -> list[Notice]:
    """Returns the notices of all third-party parts of the package just built. Raises LicenceError."""
    manifest = json.loads((root / "build" / "package-contents.json").read_text("utf-8"))
    # a library that loads itself, such as cv2, is packed as binaries only
    folders = [name.partition("/")[0] for name, _ in manifest["binaries"]]
    found = [
        *python_notices([*manifest["modules"], *folders]),
        *npm_notices(root / "ui"),
        *(windows_notices if sys.platform == "win32" else system_notices)(manifest["binaries"]),
        *gesture_notices(root),
    ]
    check(found)
    return found


def check(found: list[Notice]) -> None:
    """Raises LicenceError for parts under GPL or AGPL, or without a licence."""
    wrong = [notice for notice in found if not notice.licence or not may_ship(notice.licence)]
    if wrong:
        raise LicenceError(
            "; ".join(f"{notice.name}: {notice.licence or 'no licence'}" for notice in wrong)
        )


def may_ship(licence: str) -> bool:
    """True if one alternative of a licence expression is neither GPL nor AGPL; runtime exceptions are allowed."""
    choices = re.split(r"\bOR\b", licence)
    return any(not _FORBIDDEN.search(choice.upper()) or "exception" in choice for choice in choices)


def python_notices(modules: list[str]) -> Iterator[Notice]:
    """Notices of the distributions of the packed modules."""
    owners = metadata.packages_distributions()
    names = {owner for module in modules for owner in owners.get(module.partition(".")[0], ())}
    yield Notice("Python", ".".join(map(str, sys.version_info[:3])), "PSF-2.0")
    yield Notice(
        "PyInstaller bootloader",
        metadata.version("pyinstaller"),
        "GPL-2.0-or-later WITH Bootloader-exception",
    )
    for name in sorted(names - {"pinel-desktop", "pyinstaller"}):
        distribution = metadata.distribution(name)
        yield Notice(
            name,
            distribution.version,
            _licence_of(distribution.metadata) or UNNAMED_LICENCES.get(name, ""),
            tuple(_texts_of(distribution)),
            "pypi",
        )


def _licence_of(fields: Any) -> str:
    """Returns the licence expression, else the classifiers, else the first line of the free text."""
    if expression := fields.get("License-Expression"):
        return str(expression)
    classifiers = [
        line for line in fields.get_all("Classifier", ()) if line.startswith("License ::")
    ]
    names = [
        line.rpartition(" :: ")[2] for line in classifiers if not line.endswith("OSI Approved")
    ]
    return " OR ".join(names) or str(fields.get("License") or "").partition("\n")[0]


def _texts_of(distribution: metadata.Distribution) -> Iterator[str]:
    for file in distribution.files or ():
        if ".dist-info/" in str(file) and _TEXTS.search(str(file)):
            path = Path(str(distribution.locate_file(file)))
            if path.is_file():
                yield path.read_text("utf-8", errors="replace").strip()


def npm_notices(ui: Path) -> Iterator[Notice]:
    """Notices of the page's npm packages, transitive dependencies included."""
    packages = json.loads((ui / "package-lock.json").read_text("utf-8"))["packages"]
    waiting, visited = list(packages[""]["dependencies"]), set(NOT_IN_THE_PAGE)
    while waiting:
        name = waiting.pop()
        if name in visited:
            continue
        visited.add(name)
        package, folder = packages[f"node_modules/{name}"], ui / "node_modules" / name
        waiting += package.get("dependencies", ())
        licence = package.get("license") or _npm_licence(folder)
        yield Notice(name, str(package["version"]), str(licence), tuple(_npm_texts(folder)), "npm")


def _npm_licence(folder: Path) -> str:
    manifest: Mapping[str, Any] = json.loads((folder / "package.json").read_text("utf-8"))
    return str(manifest.get("license", ""))


def _npm_texts(folder: Path) -> Iterator[str]:
    for file in sorted(folder.glob("*")):
        if file.is_file() and _TEXTS.search(file.name):
            yield file.read_text("utf-8", errors="replace").strip()


def system_notices(binaries: list[list[str]]) -> Iterator[Notice]:
    """Notices of the shared libraries of the system."""
    found = set()
    for name, source in binaries:
        file = Path(name).name
        if "/" in name or not file.startswith("lib") or "site-packages" in source:
            continue
        row = contents.library_of(file)
        found.add(Notice(row.work, "", row.licence) if row else Notice(file, "", ""))
    yield from sorted(found)


def windows_notices(binaries: list[list[str]]) -> Iterator[Notice]:
    """Notices of the libraries that come with Python on Windows, and of WebView2's, which pywebview brings."""
    found = set()
    for name, source in binaries:
        file = PureWindowsPath(name).name.lower()
        rows = [row for start, row in WINDOWS_LIBRARIES.items() if file.startswith(start)]
        if rows:
            found.add(Notice(rows[0][0], "", rows[0][1]))
        elif file.endswith(".dll") and "site-packages" not in source:
            found.add(Notice(file, "", ""))
    yield from sorted(found)


def gesture_notices(root: Path) -> Iterator[Notice]:
    """Notices of the hand networks, which set-up converts, and of the training pictures of the letters' classifier."""
    licence = root / "pinel_desktop" / "gestures" / "weights" / "mediapipe-LICENSE.txt"
    pinned = re.search(
        r"^mediapipe==(\S+)", (root / "requirements-models.lock").read_text("utf-8"), re.M
    )
    version = pinned[1] if pinned else ""
    yield Notice(MEDIAPIPE, version, "Apache-2.0, converted to ONNX", (licence.read_text("utf-8"),))
    yield Notice(LIBRAS, "", "CC-BY-4.0")


def as_text(found: list[Notice]) -> str:
    """Returns the list of parts, then each licence text once."""
    lines = ["PINEL Desktop ships the following works of others, with thanks.", ""]
    lines += [
        f"{notice.name} {notice.version}".strip() + f": {notice.licence}"
        for notice in sorted(found)
    ]
    by_text: dict[str, list[str]] = {}
    for notice in sorted(found):
        for text in notice.texts:
            by_text.setdefault(text, []).append(notice.name)
    for text, names in by_text.items():
        lines += ["", "-" * 80, ", ".join(dict.fromkeys(names)), "-" * 80, "", text]
    return "\n".join(lines) + "\n"


def main() -> None:
    root = Path(__file__).resolve().parents[1]
    try:
        Path(sys.argv[1]).write_text(as_text(parts(root)), "utf-8")
    except LicenceError as error:
        sys.exit(f"May not ship: {error}")


if __name__ == "__main__":
    main()
