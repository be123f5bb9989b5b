"""Health checks of this PC, with codes that the command `doctor` prints as messages.

Nothing here writes to the database or uses the network. The window and the first camera are opened briefly.
"""

import contextlib
import getpass
import importlib.util
import os
import platform
import queue
import shutil
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, field
from importlib import resources
from pathlib import Path
from typing import Literal

from pinel_desktop import __version__
from pinel_desktop.app_database import is_lasting
from pinel_desktop.camera.client import CameraClient, CameraState
from pinel_desktop.database_locations import is_location_missing
from pinel_desktop.desktop.backends import (
    Backend,
    NoWindowError,
    Pc,
    Toolkit,
    backends,
    find_browser,
)
from pinel_desktop.desktop.trial import window_problem
from pinel_desktop.engine.client import EngineClient
from pinel_desktop.errors import PinelError
from storage.errors import StoreError
from storage.exchange.backup_share import COPIES_BACKUPS, SHARED_FOLDER
from storage.file import log
from storage.file.backups import damage_of, folder_of, list_backups, time_of
from storage.file.commit_counter import CommitRecord, read_counter
from storage.file.opening import prepare_reading
from storage.file.replacing import is_lost_file
from storage.file.share_copies import read_manifest
from storage.sqlite import has_wal_fault, sqlite3
from storage.text import from_json, local_time

Level = Literal["ok", "warn", "fail"]

_LITTLE_SPACE = 2**30
_TOO_LITTLE_SPACE = 50 * 2**20
_REFUSALS = ("database_foreign", "database_newer", "database_is_bundle")
_BACKUPS_BEHIND_S = 2 * 86_400.0
_ENGINE_TIMEOUT_S = 20.0
_CAMERA_TIMEOUT_S = 20.0
_ROS_FOLDER = Path("/opt/ros")


@dataclass(frozen=True, slots=True)
class HealthCheckResult:
    """One line of the report: the subject, its level, and the code and parameters of the message."""

    about: str
    level: Level
    code: str
    params: Mapping[str, object] = field(default_factory=dict)


def examine(database: Path, pc: Pc | None = None) -> Iterator[HealthCheckResult]:
    """Yields the results one by one, the most important subjects first."""
    yield _version()
    yield from _page()
    yield from _window(pc or Pc())
    yield _engine()
    yield from _disk(database.parent)
    yield from _forgetful_disk(database)
    yield _sqlite()
    yield _database(database)
    yield from _damaged_copies(database)
    yield _backups(database)
    yield from _copies(database)
    yield from _signs(Path("/dev"))
    yield _ros(os.environ, _ROS_FOLDER)


def size_text(n_bytes: int) -> str:
    """Returns a size as text, such as 1500 MB or 83 GB; without decimals, whose sign depends on the language."""
    for unit, factor in (("GB", 10**9), ("MB", 10**6), ("kB", 10**3)):
        if n_bytes >= 10 * factor:
            return f"{n_bytes // factor} {unit}"
    return f"{n_bytes} B"


def _version() -> HealthCheckResult:
    about = {"version": __version__, "python": platform.python_version(), "system": _system_name()}
    return HealthCheckResult("program", "ok", "doctor_version_ok", about)


def _system_name() -> str:
    try:
        return platform.freedesktop_os_release()["PRETTY_NAME"]
    except (OSError, KeyError):
        return f"{platform.system()} {platform.release()}"


def _page() -> Iterator[HealthCheckResult]:
    """Checks the page, which is missing only in a fresh clone; wheels and packages contain it."""
    if (resources.files("pinel_desktop.web") / "static" / "index.html").is_file():
        yield HealthCheckResult("page", "ok", "doctor_page_ok")
    else:
        yield HealthCheckResult("page", "fail", "doctor_page_missing")


def _window(
    pc: Pc, window_problem: Callable[[Toolkit], NoWindowError | None] = window_problem
) -> Iterator[HealthCheckResult]:
    """Tries the backends for the window; yields the first that works, and the problems of the better ones."""
    if not pc.has_screen:
        yield HealthCheckResult("window", "warn", "doctor_window_none")
        return
    problems = []
    for backend in backends(pc):
        problem = _problem_of(backend, window_problem)
        if problem is None and backend.name != "browser":
            yield HealthCheckResult("window", "ok", "doctor_window_ok", {"backend": backend.name})
            return
        if problem is None:
            program = Path(find_browser(pc) or "").name
            yield HealthCheckResult("window", "warn", "doctor_window_browser", {"program": program})
            break
        problems.append(HealthCheckResult("window", "warn", problem.code, problem.params))
    else:
        yield HealthCheckResult("window", "warn", "doctor_window_address")
    yield from problems


def _problem_of(
    backend: Backend, window_problem: Callable[[Toolkit], NoWindowError | None]
) -> NoWindowError | None:
    """Returns the problem of a backend; None if it can show the page. Opens no browser, as it is the person's own."""
    if backend.problem is not None:
        return NoWindowError(backend.problem, **backend.params)
    return None if backend.name == "browser" else window_problem(backend.name)


def _engine() -> HealthCheckResult:
    started = time.monotonic()
    engine = EngineClient(lambda event: None)
    engine.start()
    try:
        ready = engine.wait_until_ready(_ENGINE_TIMEOUT_S)
    finally:
        engine.close()
    seconds = {"seconds": round(time.monotonic() - started, 1)}
    return HealthCheckResult(
        "engine",
        "ok" if ready else "fail",
        "doctor_engine_ok" if ready else "doctor_engine_lost",
        seconds,
    )


def _disk(folder: Path) -> Iterator[HealthCheckResult]:
    """Checks free space and write permission of the folder, or of its nearest existing parent."""
    while not folder.exists():
        folder = folder.parent
    free = shutil.disk_usage(folder).free
    params = {"free": size_text(free), "folder": str(folder), "free_bytes": free}
    if free >= _LITTLE_SPACE:
        yield HealthCheckResult("disk", "ok", "doctor_disk_ok", params)
    else:
        yield HealthCheckResult(
            "disk", "warn" if free >= _TOO_LITTLE_SPACE else "fail", "doctor_disk_low", params
        )
    if not os.access(folder, os.W_OK):
        yield HealthCheckResult("disk", "fail", "doctor_folder_closed", {"folder": str(folder)})


def _forgetful_disk(database: Path) -> Iterator[HealthCheckResult]:
    if not is_lasting(database):
        about = {"folder": str(database.parent)}
        yield HealthCheckResult("disk", "warn", "doctor_disk_not_lasting", about)


def _sqlite(version: str = sqlite3.sqlite_version) -> HealthCheckResult:
    """Checks the SQLite library that the store uses: the system's library may have a fault that can lose a write."""
    if has_wal_fault(version):
        return HealthCheckResult("sqlite", "warn", "doctor_sqlite_old", {"version": version})
    return HealthCheckResult("sqlite", "ok", "doctor_sqlite_ok", {"version": version})


def _database(path: Path) -> HealthCheckResult:
    if absent := _absent(path):
        return absent
    params: dict[str, object] = {"path": str(path)}
    known = read_counter(path)
    size = path.stat().st_size
    params |= {"size": size_text(size), "size_bytes": size}
    if problem := _damage(path):
        return HealthCheckResult(
            "database", "fail", "doctor_database_damaged", params | {"problem": problem}
        )
    if refusal := _refusal(path):
        return HealthCheckResult("database", "fail", refusal, params)
    if not os.access(path, os.W_OK):
        return HealthCheckResult("database", "fail", "doctor_database_read_only", params)
    if incomplete := _incomplete(path, known):
        return incomplete
    if n_rows := _query(path, "SELECT count(*) FROM pragma_foreign_key_check"):
        params |= {"n_rows": n_rows}
        return HealthCheckResult("database", "warn", "doctor_database_inconsistent", params)
    if n_values := _damaged_values(path):
        return HealthCheckResult(
            "database", "warn", "doctor_values_damaged", params | {"n_rows": n_values}
        )
    return HealthCheckResult("database", "ok", "doctor_database_ok", params)


def _absent(path: Path) -> HealthCheckResult | None:
    """Returns the result if there is no database file to examine; None if there is one."""
    params = {"path": str(path)}
    if is_location_missing(path):
        about = params | {"folder": str(path.parent)}
        return HealthCheckResult("database", "fail", "database_place_missing", about)
    is_there = path.exists()
    if is_there and not path.is_file():  # a folder, or a pipe, which would block the reader
        return HealthCheckResult("database", "fail", "database_foreign", params)
    if (not is_there or not path.stat().st_size) and is_lost_file(path, by_log=True):
        return HealthCheckResult("database", "fail", "doctor_database_gone", params)
    return None if is_there else HealthCheckResult("database", "ok", "doctor_database_new", params)


def _refusal(path: Path) -> str | None:
    """Returns the code if PINEL refuses an intact file: it is of another program, of a newer release, or a bundle."""
    try:
        prepare_reading(path)
    except StoreError as error:
        return error.code if error.code in _REFUSALS else None
    return None


def _damaged_values(path: Path) -> object:
    """Returns the number of versions and runs that the app found damaged; 0 for a file of an earlier release."""
    with contextlib.suppress(sqlite3.OperationalError):
        return _query(path, "SELECT count(*) FROM content_sums WHERE damaged_at IS NOT NULL")
    return 0


def _incomplete(path: Path, known: CommitRecord | None) -> HealthCheckResult | None:
    """Returns a result if saved work is missing from the file; None if none is missing, as far as can be determined."""
    n_missing = known.n_saves - int(str(_query(path, "PRAGMA user_version"))) if known else 0
    if known is not None and n_missing <= 0:
        return None
    params: dict[str, object] = {"path": str(path), "name": log.path_of(path).name}
    if log.lost_commits(path):
        return HealthCheckResult("database", "fail", "doctor_database_end", params)
    if known is None:
        return None
    params |= {"time": local_time(known.at), "n_saves": n_missing}
    return HealthCheckResult("database", "warn", "doctor_database_earlier", params)


def _damaged_copies(path: Path) -> Iterator[HealthCheckResult]:
    """Reports damaged files that an earlier start left beside the database."""
    found = sorted(path.parent.glob(f"{path.stem}.damaged-*{path.suffix}"))
    if found:
        params = {"folder": str(path.parent), "files": ", ".join(one.name for one in found)}
        yield HealthCheckResult("database", "warn", "doctor_database_aside", params)


def _damage(path: Path) -> str | None:
    """Runs SQLite's integrity check, read-only; returns its error, None if the file is intact."""
    try:
        verdict = str(_query(path, "PRAGMA integrity_check(1)"))
    except sqlite3.Error as error:
        return str(error)
    return None if verdict == "ok" else verdict


def _query(path: Path, sql: str) -> object:
    # in a read-only folder, a file in WAL mode can only be opened as immutable
    mode = "mode=ro" if os.access(path.parent, os.W_OK) else "mode=ro&immutable=1"
    address = f"{path.absolute().as_uri()}?{mode}"
    with closing(sqlite3.connect(address, uri=True)) as connection:
        found: object = connection.execute(sql).fetchone()[0]
        return found


def _backups(path: Path) -> HealthCheckResult:
    """Reports the number of backups, whether the newest is intact, and whether it is recent."""
    found = list_backups(path)
    params: dict[str, object] = {"n_backups": len(found), "folder": str(folder_of(path))}
    if not found:
        return HealthCheckResult(
            "backups", "warn" if path.exists() else "ok", "doctor_backups_none", params
        )
    newest = found[0]
    params |= {"time": local_time(newest.made_at), "name": newest.path.name}
    if damage_of(newest.path) is not None:
        return HealthCheckResult("backups", "warn", "doctor_backups_bad", params)
    # compare with the last change, not with today: holidays must not cause a warning
    behind_s = path.stat().st_mtime - newest.made_at.timestamp() if path.exists() else 0.0
    if behind_s > _BACKUPS_BEHIND_S:
        return HealthCheckResult("backups", "warn", "doctor_backups_old", params)
    return HealthCheckResult("backups", "ok", "doctor_backups_ok", params)


def _copies(path: Path) -> Iterator[HealthCheckResult]:
    """Reports whether backups are copied to the school's folder, and the time of the newest copy.

    Reads the manifest only, and does not access the school's folder.
    """
    if not path.exists():
        return
    shared = _setting(path, COPIES_BACKUPS) and _setting(path, SHARED_FOLDER)
    if not shared:
        yield HealthCheckResult("backups", "ok", "doctor_copies_off")
        return
    found = read_manifest(path)
    if found is None or found.finished is None:
        yield HealthCheckResult("backups", "warn", "doctor_copies_none", {"folder": shared})
        return
    made_at = local_time(time_of(found.finished))
    params = {"time": made_at, "folder": str(found.finished.parent)}
    yield HealthCheckResult("backups", "ok", "doctor_copies_ok", params)


def _setting(path: Path, key: str) -> object:
    """Returns a setting of the database; None if it was never set, or the file cannot be read."""
    with contextlib.suppress(sqlite3.Error, TypeError, ValueError):
        return from_json(str(_query(path, f"SELECT value FROM settings WHERE key = '{key}'")))
    return None


def _signs(folder: Path, source: str = "0") -> Iterator[HealthCheckResult]:
    """Checks whether signs can be recognised, and whether the camera delivers pictures; by default the first camera."""
    states: queue.SimpleQueue[CameraState] = queue.SimpleQueue()
    camera = CameraClient(source, lambda event: None, states.put, lambda run, capture: None)
    started = time.monotonic()
    try:
        camera.start()
        yield _recognition(camera, started)
        without = _no_camera(folder)
        if without:
            yield without
        elif not camera.state.problem:
            camera.switch_on()
            yield _camera(folder, states)
    finally:
        camera.close()


def _recognition(camera: CameraClient, started: float) -> HealthCheckResult:
    ready = camera.wait_until_ready(_CAMERA_TIMEOUT_S)
    if problem := camera.state.problem:
        return HealthCheckResult("signs", "warn", problem.code, problem.params)
    seconds = {"seconds": round(time.monotonic() - started, 1)}
    code = "doctor_signs_ok" if ready else "doctor_signs_lost"
    return HealthCheckResult("signs", "ok" if ready else "warn", code, seconds)


def _no_camera(folder: Path) -> HealthCheckResult | None:
    """Returns the problem if no camera can be opened; None if one may work."""
    devices = sorted(folder.glob("video*"))
    if not devices:
        return HealthCheckResult("camera", "warn", "doctor_camera_none")
    if not any(os.access(device, os.R_OK | os.W_OK) for device in devices):
        params = {"devices": _names(devices), "user": _user()}
        return HealthCheckResult("camera", "warn", "doctor_camera_closed", params)
    return None


def _camera(folder: Path, states: "queue.SimpleQueue[CameraState]") -> HealthCheckResult:
    """Waits for the opened camera's first picture, or its problem."""
    deadline, problem = time.monotonic() + _CAMERA_TIMEOUT_S, PinelError("camera_no_picture")
    while (left_s := deadline - time.monotonic()) > 0.0:
        with contextlib.suppress(queue.Empty):
            state = states.get(timeout=left_s)
            if state.mode == "on":
                devices = _names(sorted(folder.glob("video*")))
                return HealthCheckResult("camera", "ok", "doctor_camera_ok", {"devices": devices})
            problem = state.problem or problem
    return HealthCheckResult("camera", "warn", problem.code, problem.params)


def _names(devices: Sequence[Path]) -> str:
    return ", ".join(map(str, devices))


def _user() -> str:
    try:
        return getpass.getuser()
    except (KeyError, OSError):  # a user id without a name
        return "$USER"


def _ros(
    environ: Mapping[str, str],
    folder: Path,
    find: Callable[[str], object | None] = importlib.util.find_spec,
) -> HealthCheckResult:
    """Checks for ROS in this terminal, a ROS installation on the disk, and the DDS library, which needs no ROS."""
    found = []
    if find("rclpy") is not None:
        found.append(f"ROS 2 {environ.get('ROS_DISTRO', '')}".strip())
    if find("cyclonedds") is not None:
        found.append("Cyclone DDS")
    if found:
        return HealthCheckResult("ros", "ok", "doctor_ros_ok", {"found": ", ".join(found)})
    installed = sorted(folder.glob("*/setup.bash"))
    if installed:
        return HealthCheckResult(
            "ros", "warn", "doctor_ros_unsourced", {"path": str(installed[-1].parent)}
        )
    return HealthCheckResult("ros", "ok", "doctor_ros_none")
