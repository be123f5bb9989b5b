"""`--self-check`: an end-to-end test, from the window to a run read back from the disk.

The check uses HTTP as the page does. The engine drives a square of 1 m in the simulator in real time. The judge must
find that this run passes the activity `square`. Then a second program waits for two recorded signs: it draws a small
square after B, and a triangle after A.
"""

import contextlib
import http.cookiejar
import json
import platform
import tempfile
import time
import urllib.request
from collections.abc import Iterator, Mapping
from importlib import metadata
from pathlib import Path
from typing import Any

from pinel_desktop import __version__
from pinel_desktop.desktop.app_process import AppProcess
from pinel_desktop.desktop.backends import Pc, Toolkit, backends
from pinel_desktop.desktop.presenter import TITLE, USABLE
from pinel_desktop.desktop.screen import any_screen
from pinel_desktop.errors import PinelError
from pinel_desktop.instance import InstanceLock
from pinel_desktop.messages import describe, language_of_system
from storage import StoreError, open_store
from storage.sqlite import sqlite3

Json = dict[str, Any]

SQUARE: Json = {
    "pinel_ir": 1,
    "name": "self-check",
    "functions": [],
    "commands": [
        {
            "action": "repeat",
            "times": 4,
            "commands": [
                {"action": "move_forward", "distance": 1},
                {"action": "turn", "angle": 90},
            ],
        }
    ],
}
MISSION: Json = {"world": "empty_room", "preset": "ideal", "feedback": "pose", "activity": "square"}
EXPECTED_SIGNS = ["B", "A"]
RECORDED_SIGNS = Path(__file__).parents[1] / "camera" / "recordings" / "b_a.npz"
MAX_CLOSING_ERROR_M = 1e-4
_READY_S = 60.0
_RUN_S = 60.0
_PAUSE_S = 0.05
_LIBRARIES = ("pywebview", "flask", "pydantic", "pymunk", "numpy", "sqlite-utils")


def check(database: Path | None) -> Json:
    """Runs the self-check on `database`, or on a temporary one.

    Returns `{"ok", "window", "run", "judged", "signs", "store", "versions"}`, and `"error"` with code, message and
    remedy if a part failed; parts that were not reached are missing.
    """
    result: Json = {"ok": False, "versions": _versions()}
    try:
        with _database(database) as path, any_screen() as virtual:
            result["window"] = {"virtual_screen": virtual}
            with _app(path) as app:
                _in_window(app, result)
            result["store"] = _read_back(path, result["run"]["id"])
        result["ok"] = _is_well(result)
    except (PinelError, StoreError) as error:
        result["error"] = _as_text(error.code, error.params)
    except Exception as error:  # the caller always gets an object
        result["error"] = _as_text("self_check_failed", {"problem": repr(error)})
    return result


def _as_text(code: str, params: Mapping[str, object]) -> Json:
    text = describe(code, params, language_of_system())
    return {"code": code, "message": text.message, "remedy": text.full_remedy}


def _is_well(result: Json) -> bool:
    run, store = result["run"], result["store"]
    drove = run["state"] == "finished" and run["closing_error_m"] <= MAX_CLOSING_ERROR_M
    is_stored = store["telemetry_sha256"] == run["telemetry_sha256"] and store["ticks"] > 0
    return bool(drove and is_stored and result["judged"] and result["signs"] == EXPECTED_SIGNS)


@contextlib.contextmanager
def _app(database: Path) -> Iterator[AppProcess]:
    """Runs the app in a process of its own, as for the window."""
    instance = InstanceLock(database)
    instance.acquire()
    app = AppProcess(
        database, on_request=lambda request: None, on_lost=lambda: None, camera=str(RECORDED_SIGNS)
    )
    try:
        app.start()
        yield app
    finally:
        app.close()
        instance.release()


def _in_window(app: AppProcess, result: Json) -> None:
    """Opens the window on this thread and runs the checks on the thread of the window's `on_open`."""
    # imported only now, because GTK needs a screen when it is loaded
    from pinel_desktop.desktop.window import NativeWindow  # noqa: PLC0415

    client = Client(app.address())
    program = make_program(client)
    failures: list[Exception] = []
    started = time.monotonic()

    def work() -> None:
        try:
            _wait_until_usable(window)
            result["window"]["ready_s"] = round(time.monotonic() - started, 2)
            result["run"] = drive(client, save(client, program, SQUARE, MISSION))
            result["judged"] = _judged(client, result["run"]["id"])
            result["signs"] = show_signs(client, program)
        except Exception as failure:  # re-raised on the main thread
            failures.append(failure)
        finally:
            window.close()

    window = NativeWindow(
        lambda: f"{app.address()}#/program/{program}", TITLE, app.language, on_open=work
    )
    toolkit = _toolkit()
    result["window"]["backend"] = toolkit
    window.run(toolkit)
    if failures:
        raise failures[0]
    if "run" not in result:
        raise PinelError("self_check_page_silent", seconds=0)


def _toolkit() -> Toolkit:
    """Returns the first toolkit without a problem. If there is none, raises PinelError with the first one's problem."""
    tried = backends(Pc())
    for backend in tried:
        if backend.problem is None and backend.name != "browser":
            return backend.name
    raise PinelError(tried[0].problem or "window_no_screen", **tried[0].params)


def _wait_until_usable(window: Any) -> None:
    deadline = time.monotonic() + _READY_S
    while window.run_script(USABLE) is not True:
        if time.monotonic() > deadline:
            raise PinelError("self_check_page_silent", seconds=_READY_S)
        time.sleep(_PAUSE_S)


class Client:
    """HTTP client that behaves like the page."""

    def __init__(self, address: str) -> None:
        cookies = urllib.request.HTTPCookieProcessor(http.cookiejar.CookieJar())
        self._opener = urllib.request.build_opener(urllib.request.ProxyHandler({}), cookies)
        self._origin = address.partition("/?")[0]
        self._opener.open(address, timeout=_READY_S).close()

    def get(self, path: str) -> Json:
        return self._ask(urllib.request.Request(self._origin + path))

    def post(self, path: str, body: Json) -> Json:
        data = json.dumps(body).encode()
        headers = {"Content-Type": "application/json"}
        return self._ask(urllib.request.Request(self._origin + path, data, headers))

    def _ask(self, request: urllib.request.Request) -> Json:
        with self._opener.open(request, timeout=_READY_S) as answer:
            found: Json = json.load(answer)
            return found


def make_program(client: Client) -> str:
    """Creates a group and its program, a square; returns the id of the program."""
    group = client.post("/api/groups", {"name": f"self-check {time.time_ns()}"})
    program = client.post(f"/api/groups/{group['id']}/programs", {"name": SQUARE["name"]})
    save(client, program["id"], SQUARE)
    return str(program["id"])


def save(client: Client, program: str, document: Json, setup: Json | None = None) -> str:
    """Saves a version of a program; returns its id."""
    content = {"workspace": {}, "document": document, "setup": setup}
    version: str = client.post(f"/api/programs/{program}/versions", content)["id"]
    return version


def signed_polygons() -> Json:
    """Returns a program that waits for B and draws a square, then waits for A and draws a triangle."""
    commands: list[Json] = []
    for sign, n_sides in zip(EXPECTED_SIGNS, (4, 3), strict=True):
        wait = {"action": "classify_gestures", "timeout": 5}
        side = [
            {"action": "move_forward", "distance": 0.1},
            {"action": "turn", "angle": 360 / n_sides},
        ]
        commands += [
            {"action": "while", "condition": f"result != '{sign}'", "commands": [wait]},
            {"action": "repeat", "times": n_sides, "commands": side},
        ]
    return {**SQUARE, "commands": commands}


def show_signs(client: Client, program: str) -> list[str]:
    """Runs a program that depends on recorded signs; returns the signs that the camera recognised, each once."""
    run = drive(client, save(client, program, signed_polygons()), speed=10.0)
    return signs_of(client, run["id"])


def signs_of(client: Client, run: str) -> list[str]:
    """Returns the signs that the camera recognised in a run, each once."""
    events = client.get(f"/api/runs/{run}/events")["events"]
    signs = [event["result"] for event in events if event.get("by") == "camera"]
    return list(dict.fromkeys(signs))


def _judged(client: Client, run: str) -> bool:
    """Returns whether a run passes its activity, by the verdict of the judge process."""
    _wait_for(lambda: client.get(f"/api/runs/{run}")["passed"] is not None, _RUN_S)
    return bool(client.get(f"/api/runs/{run}")["passed"])


def drive(client: Client, version: str, speed: float = 1.0) -> Json:
    """Runs the version in the engine and returns the app's answer about the run."""
    _wait_for(lambda: client.get("/api/status")["engine"] == "ready", _READY_S)
    run = client.post("/api/runs", {"version_id": version, "world": "empty_room", "speed": speed})
    _wait_for(lambda: client.get(f"/api/runs/{run['id']}")["ended_at"] is not None, _RUN_S)
    ended = client.get(f"/api/runs/{run['id']}")
    keys = (
        "id",
        "state",
        "reason",
        "closing_error_m",
        "duration_s",
        "n_executed",
        "telemetry_sha256",
    )
    return {key: ended[key] for key in keys}


def _wait_for(reached: Any, timeout_s: float) -> None:
    deadline = time.monotonic() + timeout_s
    while not reached():
        if time.monotonic() > deadline:
            raise PinelError("engine_not_ready")
        time.sleep(_PAUSE_S)


def _read_back(path: Path, run_id: str) -> Json:
    """Reads the run from the file, opened again after the app has closed it."""
    with contextlib.closing(open_store(path)) as store:
        run = store.runs.get(run_id)
        return {
            "state": run.state,
            "telemetry_sha256": run.telemetry_sha256,
            "events": len(store.runs.events(run_id)),
            "ticks": len(store.runs.telemetry(run_id).rows),
        }


@contextlib.contextmanager
def _database(given: Path | None) -> Iterator[Path]:
    if given is not None:
        yield given
        return
    with tempfile.TemporaryDirectory(prefix="pinel-self-check-") as folder:
        yield Path(folder) / "pinel.db"


def _versions() -> Json:
    versions = {"pinel-desktop": __version__, "python": platform.python_version()}
    for library in _LIBRARIES:
        with contextlib.suppress(metadata.PackageNotFoundError):  # packages may lack metadata
            versions[library] = metadata.version(library)
    versions["sqlite"] = sqlite3.sqlite_version
    return versions
