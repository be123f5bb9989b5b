"""The report of a PC for support: the diagnosis and the state of the files, without the pupils' work or names."""

import contextlib
import json
import os
import platform
import sys
from collections.abc import Iterator, Sequence
from datetime import UTC, datetime
from importlib import metadata
from pathlib import Path
from typing import Any

from pinel_desktop import __version__
from pinel_desktop.processes import log_file
from pinel_desktop.settings import Settings
from storage.sqlite import sqlite3

# without the settings that hold keys of groups, classes and versions
_SETTINGS = ("pinel_language", "pinel_camera", "pinel_theme", "pinel_muted", "pinel_loudness")
_LIBRARIES = ("pywebview", "flask", "numpy", "pymunk", "onnxruntime", "opencv-python-headless")
_MAX_LOG_LINES = 200
_VARIABLES = ("LANG", "XDG_CURRENT_DESKTOP", "XDG_SESSION_TYPE", "DISPLAY", "WAYLAND_DISPLAY")


def write_report(target: Path, database: Path, findings: Sequence[dict[str, Any]]) -> None:
    """Writes the report as JSON.

    Args:
        findings: the results of `pinel doctor`.

    Raises:
        OSError: the file cannot be written.
    """
    report = {
        "report": 1,
        "made_at": datetime.now(UTC).isoformat(timespec="seconds"),
        "program": _program(),
        "machine": _machine(),
        "findings": findings,
        "settings": _settings(database),
        "files": list(_files(database)),
        "rows": _rows(database),
        "logs": _logs(database),
    }
    text = json.dumps(report, ensure_ascii=False, indent=1)
    target.write_text(_without_home(text), "utf-8")


def _program() -> dict[str, Any]:
    libraries = {}
    for name in _LIBRARIES:
        with contextlib.suppress(
            metadata.PackageNotFoundError
        ):  # the package ships not all metadata
            libraries[name] = metadata.version(name)
    return {
        "version": __version__,
        "python": platform.python_version(),
        "is_packaged": bool(getattr(sys, "frozen", False)),
        "libraries": libraries | {"sqlite": sqlite3.sqlite_version},
    }


def _machine() -> dict[str, Any]:
    import psutil  # noqa: PLC0415 - only for a report

    memory = psutil.virtual_memory()
    return {
        "system": platform.platform(),
        "processor": platform.machine(),
        "n_cores": os.cpu_count(),
        "memory_mb": memory.total // 2**20,
        "free_memory_mb": memory.available // 2**20,
        "environment": {name: os.environ[name] for name in _VARIABLES if name in os.environ},
    }


def _settings(database: Path) -> dict[str, str]:
    chosen = Settings.beside(database).chosen
    return {name: chosen[name] for name in _SETTINGS if name in chosen}


def _logs(database: Path) -> dict[str, list[str]]:
    """Returns the last lines of the log of each process."""
    logs = {name: log_file.read_log(name, database, _MAX_LOG_LINES) for name in log_file.PROCESSES}
    return {name: lines for name, lines in logs.items() if lines}


def _files(database: Path) -> Iterator[dict[str, Any]]:
    """Yields name, size and time of the files in the data folder, of the backups and of the logs."""
    for folder in (database.parent, database.parent / "backups", log_file.folder_of(database)):
        for path in sorted(folder.glob(f"{database.stem}*")) if folder.is_dir() else ():
            with contextlib.suppress(OSError):
                found = path.lstat()
                changed = datetime.fromtimestamp(found.st_mtime, UTC)
                yield {
                    "name": str(path.relative_to(database.parent)),
                    "bytes": found.st_size,
                    "changed_at": changed.isoformat(timespec="seconds"),
                }


def _rows(database: Path) -> dict[str, int]:
    """Returns the number of rows of each table; empty if the database cannot be read."""
    if not database.is_file():
        return {}
    try:
        with contextlib.closing(sqlite3.connect(f"{database.as_uri()}?mode=ro", uri=True)) as db:
            query = "SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE 'sqlite_%' ORDER BY name"
            names = [str(row[0]) for row in db.execute(query)]
            return {name: _count(db, name) for name in names}
    except sqlite3.Error:
        return {}


def _count(db: sqlite3.Connection, table: str) -> int:
    quoted = table.replace('"', '""')
    return int(db.execute(f'SELECT count(*) FROM "{quoted}"').fetchone()[0])


def _without_home(text: str) -> str:
    """Replaces the home folder, whose name is often the name of a person."""
    home = json.dumps(str(Path.home()), ensure_ascii=False)[1:-1]
    return text.replace(home, "~") if home != os.sep else text
