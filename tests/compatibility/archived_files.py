"""Reads the files that an earlier release wrote, over HTTP and by commands only.

Used by the script that wrote the files and by the tests that read them, so that both make the same queries.
"""

import gzip
import hashlib
import importlib.metadata
import json
import math
import platform
import struct
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from click.testing import CliRunner

from pinel_desktop.cli import main
from storage import open_store
from storage.sqlite import sqlite3
from tests.e2e.app_process import AppProcess
from tests.web.browser import Browser

FILES = Path(__file__).parent / "files"
PROGRAMS = FILES / "programs"
SAMPLES = Path(__file__).parents[1] / "programs"
PIN = "2468"
DATABASE = "pinel.db"

_TEXTS = ("message", "remedy")  # texts may change at any time
_LONG = ("workspace", "document", "world_document", "path")  # recorded as digests


def recorded(name: str) -> Any:
    """A record: `summary` of the databases and bundles, `results` of the programs."""
    return json.loads((FILES / f"{name}.json").read_text("utf-8"))


def unpack(name: str, target: Path) -> Path:
    """Unpacks a file, or all files of a folder, to `target`; returns the target."""
    if (FILES / name).is_dir():
        for packed in sorted((FILES / name).rglob("*.gz")):
            place = packed.relative_to(FILES / name).with_suffix("")
            unpack(f"{name}/{place}", target / place)
        return target
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_bytes(gzip.decompress((FILES / f"{name}.gz").read_bytes()))
    return target


def pinel(*arguments: str | Path) -> tuple[int, str]:
    """Runs a command; returns its exit status and standard output."""
    done = CliRunner().invoke(main, [str(argument) for argument in arguments])
    return done.exit_code, done.stdout


def merged(database: Path, bundle: Path, *options: str) -> dict[str, Any]:
    """Merges a bundle; returns the report, and the content hash afterwards."""
    _, text = pinel("--db", database, "merge", bundle, "--json", *options)
    answer = json.loads(text)
    (outcome,) = answer["files"]
    names = ("error", "computer_name", "added", "changed", "skipped", "removed", "would_delete")
    return {**{name: outcome[name] for name in names}, "content_hash": answer["content_hash"]}


def verdict(database: Path, run: str) -> dict[str, Any]:
    """Repeats a run with `pinel runs verify`."""
    _, text = pinel("--db", database, "runs", "verify", run, "--json")
    answer = json.loads(text)
    return {name: answer[name] for name in ("outcome", "n_ticks", "whole", "recorded_sha256")}


def changed(database: Path, statement: str) -> None:
    """Changes a file as somebody would who knows that the store keeps sums of what it has written."""
    with closing(sqlite3.connect(database)) as connection, connection:
        connection.execute(statement)
        connection.execute("DELETE FROM content_sums")


def all_merged(folder: Path) -> dict[str, Any]:
    """Results of merging each bundle into an empty store, and the second PC's into the first one's."""
    found: dict[str, Any] = {}
    for name in ("all", "class", "anonymous", "second_pc"):
        bundle = unpack(f"bundles/{name}.pinel", folder / f"{name}.pinel")
        found[name] = merged(folder / name / DATABASE, bundle)
    home = unpack("database", folder / "both")
    found["second_pc into the database"] = merged(home / DATABASE, bundle)
    found["second_pc with --delete"] = merged(home / DATABASE, bundle, "--delete")
    with opened(home) as browser:
        programs = reported(browser)["programs"]
    found["went on elsewhere"] = {p["name"]: p["elsewhere"] for p in programs if p["elsewhere"]}
    return found


def program_brought(home: Path) -> dict[str, Any]:
    """Result of importing an exported program into an empty app."""
    octets = unpack("bundles/program.pinel", home / "program.pinel").read_bytes()
    app = AppProcess(home)
    browser = Browser.signed_in(app.start())
    try:
        brought = bring_program(browser, octets)
        wait_until_confirmed(browser)
        programs = list(_programs(browser, brought["group_id"]))
    finally:
        app.stop()
    with open_store(home / DATABASE) as store:
        found = store.exchange.content_hash()
    return {"answer": brought, "programs": programs, "content_hash": found}


def wait_until_confirmed(browser: Browser) -> None:
    """Returns when the app has repeated the runs that came without a teacher: their passes count only then."""
    assert browser.put("/api/teacher/pin", {"pin": PIN}).status == 200
    deadline = time.monotonic() + 60
    while browser.get("/api/bundles/heard").data["unconfirmed"]["waiting"]:
        assert time.monotonic() < deadline, "not confirmed"
        time.sleep(0.1)


def bring_program(browser: Browser, octets: bytes) -> dict[str, Any]:
    """Imports the file of a program into the app."""
    headers = {"Content-Type": "application/octet-stream"}
    answer = browser.send("POST", "/api/programs/file", body=octets, headers=headers)
    assert answer.status == 200, answer.body
    found: dict[str, Any] = answer.data
    return found


def backup_restored(home: Path) -> dict[str, Any]:
    """Result of opening a damaged database with backups."""
    unpack("database/backups", home / "backups")
    (home / DATABASE).write_bytes(b"damaged" * 1000)
    with open_store(home / DATABASE) as store:
        notice = store.notice and store.notice.code
        return {"notice": notice, "content_hash": store.exchange.content_hash()}


def sources(name: str) -> list[Path]:
    """A program in all of its forms."""
    places = (SAMPLES / f"{name}.json", SAMPLES / "python" / f"{name}.py")
    own = (PROGRAMS / f"{name}.json", PROGRAMS / f"{name}.py")
    return [file for file in (*places, *own) if file.exists()]


def result(file: Path, options: list[str]) -> dict[str, Any]:
    """What `pinel run` prints of a program."""
    _, text = pinel("run", file, "--json", "--no-store", *options)
    printed: dict[str, Any] = _short(json.loads(text))
    return printed


@contextmanager
def opened(home: Path) -> Iterator[Browser]:
    """The app on the folder of a database, with the teacher signed in."""
    app = AppProcess(home)
    browser = Browser.signed_in(app.start())
    try:
        assert browser.post("/api/teacher/enter", {"pin": PIN}).status == 200
        yield browser
    finally:
        app.stop()


def reported(browser: Browser) -> dict[str, Any]:
    """The whole content of the database, as the app reports it."""
    status = browser.get("/api/status").data
    classrooms = _rows(browser, "/api/classrooms", "classrooms")
    lessons = [
        lesson
        for key in [*(one["id"] for one in classrooms), "none"]
        for lesson in _rows(browser, f"/api/classrooms/{key}/lessons", "lessons")
    ]
    groups = _rows(browser, "/api/groups", "groups")
    return {
        "language": status["language"],
        "notice": status["database"]["notice"],
        "shared_folder": browser.get("/api/folders").data["shared"],
        "classrooms": classrooms,
        "lessons": lessons,
        "groups": groups,
        "programs": [one for group in groups for one in _programs(browser, group["id"])],
        "notes": [
            note
            for group in groups
            for note in _rows(browser, f"/api/groups/{group['id']}/notes", "notes")
        ],
        "runs": [_run(browser, run["id"]) for run in _rows(browser, "/api/runs?limit=200", "runs")],
        "heard": _rows(browser, "/api/bundles/heard", "computers"),
    }


def _rows(browser: Browser, path: str, name: str) -> list[dict[str, Any]]:
    answer = browser.get(path)
    assert answer.status == 200, answer.body
    rows: list[dict[str, Any]] = _short(answer.data[name])
    return rows


def _programs(browser: Browser, group: str) -> Iterator[dict[str, Any]]:
    for place in ("programs", "bin"):
        for program in _rows(browser, f"/api/groups/{group}/{place}", "programs"):
            marks = _rows(browser, f"/api/programs/{program['id']}/versions", "versions")
            versions = [_short(browser.get(f"/api/versions/{m['id']}").data) | m for m in marks]
            other_version = _short(browser.get(f"/api/programs/{program['id']}").data["elsewhere"])
            yield {**program, "versions": versions, "elsewhere": other_version}


def _run(browser: Browser, key: str) -> dict[str, Any]:
    path = f"/api/runs/{key}"
    run, events = browser.get(path).data, browser.get(f"{path}/events").data["events"]
    kinds = sorted({event["type"] for event in events})
    octets = browser.get(f"{path}/telemetry").body
    (length,) = struct.unpack_from("<I", octets)
    return {
        **_short({**run, "version": run["version"] and run["version"]["id"]}),
        "n_events": len(events),
        "kinds_of_events": kinds,
        "events": digest(events),
        "n_samples": json.loads(octets[4 : 4 + length])["rows"],
        "telemetry": hashlib.sha256(octets).hexdigest(),
    }


def _short(value: Any) -> Any:
    """The value without texts, and with digests in place of long contents."""
    if isinstance(value, list):
        return [_short(item) for item in value]
    if not isinstance(value, dict):
        return value
    return {
        name: digest(item) if _is_long(name, item) else _short(item)
        for name, item in value.items()
        if name not in _TEXTS
    }


def _is_long(name: str, item: Any) -> bool:
    """A `world` is a name in a run and a document in a version."""
    return item is not None and (name in _LONG or (name == "world" and isinstance(item, dict)))


def digest(value: Any) -> str:
    """SHA-256 of a value as JSON, whatever the order of its keys."""
    return hashlib.sha256(json.dumps(value, sort_keys=True).encode()).hexdigest()


def platform_of_figures() -> str:
    """Fingerprint of the floating-point platform; runs are bit-identical only where it is equal.

    Processors and C libraries differ in the last digit of some functions, so it includes many values of them.
    """
    values = [0.37 * n for n in range(-5000, 5000)]
    plain = [
        [math.sin(v), math.cos(v), math.tan(v), math.atan2(v, 2.0), math.hypot(v, 3.0)]
        for v in values
    ]
    array = np.array(values)
    vectors = [np.sin(array), np.cos(array), np.arctan2(array, 2.0), np.hypot(array, 3.0)]
    octets = np.array(plain).tobytes() + np.array(vectors).tobytes()
    names = [f"{name} {importlib.metadata.version(name)}" for name in ("numpy", "pymunk")]
    functions = hashlib.sha256(octets).hexdigest()[:16]
    return ", ".join([platform.system(), platform.machine(), *names, f"functions {functions}"])
