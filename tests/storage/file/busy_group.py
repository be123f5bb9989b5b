"""Processes that save, run and back up in an endless loop and report what was stored; test_kill.py kills them.

The parent reads lines `{"path": ..., "disk": [KIND, SIZE]}` and forks a child for each, which works until it is killed;
forking after the imports makes a thousand of them feasible. The parent prints the child's id and its end; all other
output is the child's.
"""

import json
import os
import random
import sys
import threading
from collections.abc import Iterator
from datetime import UTC, datetime
from itertools import count
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[3]))

import sqlite_utils  # noqa: F401 - what is imported once need not be by each child

from storage import RunRecorder, RunStart, Store, StoreError, open_store, warm_up
from storage.file.backups import make_backup
from tests.storage.sample_runs import block_started, ended, sample

PAGES, FILE_SIZE = "pages", "file size"


def text_of(n: int) -> str:
    """Text of the n-th version."""
    return f"{n} " + "x" * (n * 997 % 9000)


def report(kind: str, **about: Any) -> None:
    os.write(1, json.dumps({"kept": kind, **about}).encode() + b"\n")  # one atomic write


def edit(store: Store, group_id: str) -> None:
    program = None
    for n in count():
        try:
            program = program or store.programs.create(group_id, "P")
            version = store.versions.save(program.id, {"text": text_of(n)}, {"pinel_ir": 1})
        except StoreError as error:
            report("refused", code=error.code, problem=str(error))
        else:
            report("version", id=version.id, n=n)


def run(store: Store, version_id: str) -> None:
    recorder = RunRecorder(store)
    for n_samples in lengths():
        try:
            run_id = store.runs.begin(start_of(version_id)).id
            report("run", id=run_id)
            recorder(block_started(run_id, 0))
            for tick in range(n_samples):
                recorder(sample(run_id, tick, seq=1 + tick))
                if tick % 50 == 49:
                    recorder.flush()
            recorder(ended(run_id, 1 + n_samples, n_samples))
            recorder.flush().result()
        except StoreError as error:
            report("refused", code=error.code, problem=str(error))
        else:
            report("end of run", id=run_id, n=n_samples)


def lengths() -> Iterator[int]:
    generator = random.Random(os.getpid())
    while True:
        yield generator.randrange(200)


def start_of(version_id: str) -> RunStart:
    return RunStart(
        link="sim", world="w", world_document={}, seed=0, app_version="1", version_id=version_id
    )


def back_up(path: Path) -> None:
    for n in count():
        try:
            make_backup(path, datetime.fromtimestamp(86_400.0 * n, UTC))
        except StoreError as error:
            report("refused", code=error.code, problem=str(error))
        else:
            report("backup")


def limit(store: Store | None, disk: list[Any] | None) -> None:
    """Simulates a full disk, before the file is opened or for the writer."""
    if disk and disk[0] == FILE_SIZE and store is None:
        import resource  # noqa: PLC0415 - not available on every system

        resource.setrlimit(resource.RLIMIT_FSIZE, (disk[1], resource.RLIM_INFINITY))
    if disk and disk[0] == PAGES and store is not None:
        n_pages = "SELECT page_count FROM pragma_page_count"
        store._database.write(
            lambda db: db.execute(
                f"PRAGMA max_page_count = {db.execute(n_pages).fetchone()[0] + disk[1]}"
            ).fetchone()
        )


def be_busy(path: Path, disk: list[Any] | None) -> None:
    limit(None, disk)
    with open_store(path, close_interrupted=True) as store:
        limit(store, disk)
        groups = store.groups.all()
        group = groups[0] if groups else store.groups.create("A")
        program = store.programs.create(group.id, "runs")
        version = store.versions.save(program.id, {}, {"pinel_ir": 1})
        work: list[Any] = [(edit, store, group.id), (run, store, version.id), (back_up, path)]
        threads = [threading.Thread(target=job, args=given, daemon=True) for job, *given in work]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()


def child(path: Path, disk: list[Any] | None) -> None:
    threading.excepthook = lambda failure: report("crashed", why=repr(failure.exc_value))
    try:
        be_busy(path, disk)
    except StoreError as error:
        report("refused", code=error.code, problem=str(error))
    except BaseException as error:
        report("crashed", why=repr(error))
    finally:
        os._exit(0)


def main() -> None:
    warm_up()
    for line in sys.stdin:
        asked = json.loads(line)
        if pid := os.fork():
            report("born", pid=pid)
            os.waitpid(pid, 0)
            report("gone", pid=pid)
        else:
            child(Path(asked["path"]), asked["disk"])


if __name__ == "__main__":
    main()
