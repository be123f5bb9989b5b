"""The end comes at any moment, with room on the disk or without: what was acknowledged is there, the file is whole."""

import json
import os
import random
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import closing, contextmanager, suppress
from pathlib import Path
from typing import Any

import pytest

from storage import open_store
from storage.file.backups import damage_of, list_backups
from storage.sqlite import sqlite3
from tests.storage.file.busy_group import FILE_SIZE, PAGES, text_of

BUSY_GROUP = Path(__file__).with_name("busy_group.py")
MAX_LIFE_S = 0.35
KILLS_PER_FILE = 25
FULL_DISK = {"disk_full", "backup_no_room"}
Report = dict[str, Any]

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="kill -9")


class Nursery:
    """Has busy groups be born, and kills them."""

    def __init__(self, process: "subprocess.Popen[str]") -> None:
        self._process = process

    def reports_before_kill(
        self, path: Path, disk: list[Any] | None, after_s: float
    ) -> list[Report]:
        """Everything that a group said between its start and its end by SIGKILL, `after_s` later."""
        assert self._process.stdin is not None
        self._process.stdin.write(json.dumps({"path": str(path), "disk": disk}) + "\n")
        self._process.stdin.flush()
        reports = list(self._until("born"))
        time.sleep(after_s)
        with suppress(ProcessLookupError):  # it could not open the file on a full disk
            os.kill(reports[-1]["pid"], signal.SIGKILL)
        return reports + list(self._until("gone"))

    def _until(self, last: str) -> Iterator[Report]:
        assert self._process.stdout is not None
        for line in self._process.stdout:
            report = json.loads(line)
            yield report
            if report["kept"] == last:
                return
        raise AssertionError("the nursery is gone")


@contextmanager
def nursery() -> Iterator[Nursery]:
    with subprocess.Popen(
        [sys.executable, str(BUSY_GROUP)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env=os.environ | {"OPENBLAS_NUM_THREADS": "1"},  # no threads that a fork would leave behind
    ) as process:
        yield Nursery(process)


def some_disk(chance: random.Random) -> list[Any] | None:
    """Half of the disks have room; the others are full soon, for SQLite or for the system."""
    return chance.choice(
        [None, None, [PAGES, chance.randrange(200)], [FILE_SIZE, chance.randrange(10**5, 10**6)]]
    )


def check_file(path: Path) -> None:
    with closing(sqlite3.connect(path)) as db:
        assert db.execute("PRAGMA integrity_check").fetchall() == [("ok",)]
        assert db.execute("PRAGMA foreign_key_check").fetchall() == []
    assert [b.path.name for b in list_backups(path) if damage_of(b.path)] == []


def check_stored(path: Path, reports: list[Report]) -> None:
    with open_store(path, close_interrupted=True) as store:
        assert store.notice is None
        for line in reports:
            match line["kept"]:
                case "version":
                    workspace = store.versions.get(line["id"]).workspace
                    assert workspace == {"text": text_of(line["n"])}
                case "run":
                    assert store.runs.get(line["id"]).state in ("finished", "failed")
                case "end of run":
                    assert store.runs.get(line["id"]).state == "finished"
                    assert len(store.runs.telemetry(line["id"]).rows) == line["n"]
                    assert len(store.runs.events(line["id"])) == 2


def is_wrong(report: Report) -> bool:
    """A group crashed, or was told something else than that there is no room: its disk has no other fault."""
    return report["kept"] == "crashed" or (
        report["kept"] == "refused" and report["code"] not in FULL_DISK
    )


def kill_again_and_again(folder: Path, n_kills: int, seed: int) -> None:
    chance = random.Random(seed)
    counts: Counter[str] = Counter()
    refusals: Counter[str] = Counter()
    wrong: list[Report] = []
    with nursery() as groups:
        for first in range(0, n_kills, KILLS_PER_FILE):
            path = folder / f"{first}.db"
            reports: list[Report] = []
            for _ in range(KILLS_PER_FILE):
                reports += groups.reports_before_kill(
                    path, some_disk(chance), chance.random() * MAX_LIFE_S
                )
                check_file(path)
            check_stored(path, reports)
            counts.update(line["kept"] for line in reports)
            refusals.update(line["code"] for line in reports if line["kept"] == "refused")
            wrong += [line for line in reports if is_wrong(line)]
    print(f"\nseed {seed}: {n_kills} kills, {dict(counts)}, {dict(refusals)}")
    assert wrong == []
    kinds = ("version", "run", "end of run", "refused", "backup")
    assert min(counts[kind] for kind in kinds) > n_kills / 10


@pytest.mark.timeout(300)
def test_nothing_acknowledged_is_lost_in_fifty_kills_at_random_moments(tmp_path: Path) -> None:
    kill_again_and_again(tmp_path, 50, random.SystemRandom().randrange(2**32))


@pytest.mark.nightly
@pytest.mark.timeout(1800)
def test_nothing_acknowledged_is_lost_in_a_thousand_kills_at_random_moments(tmp_path: Path) -> None:
    kill_again_and_again(tmp_path, 1000, random.SystemRandom().randrange(2**32))
