"""The first start after an update may be killed at any moment: the work is there, and no file is half migrated."""

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import closing
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from storage import open_store
from storage.file.backups import damage_of, list_backups
from storage.sqlite import sqlite3
from storage.tables.ddl import MIGRATIONS
from tests.storage.file.interrupted_update import NEXT_MIGRATIONS
from tests.storage.file.refusals import code_of

SCRIPT = Path(__file__).with_name("interrupted_update.py")

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="kill -9")


class Updates:
    """Starts of the next release."""

    def __init__(self, process: "subprocess.Popen[str]") -> None:
        self._process = process

    def start(self, path: Path, n_steps: int | None = None) -> Any:
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.write(json.dumps({"path": str(path), "n_steps": n_steps}) + "\n")
        self._process.stdin.flush()
        return json.loads(self._process.stdout.readline())


@pytest.fixture
def updates() -> Iterator[Updates]:
    with subprocess.Popen(
        [sys.executable, str(SCRIPT)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env=os.environ | {"OPENBLAS_NUM_THREADS": "1"},  # no threads that a fork would leave behind
    ) as process:
        yield Updates(process)


@pytest.fixture
def work(tmp_path: Path) -> Path:
    """The data folder of this release, with the last edit in the log only, as after a power cut."""
    made, path = tmp_path / "made" / "pinel.db", tmp_path / "work" / "pinel.db"
    with open_store(made) as store:
        program = store.programs.create(store.groups.create("Onças").id, "P")
        store.versions.save(program.id, {"text": "last"}, {"pinel_ir": 1})
        shutil.copytree(made.parent, path.parent)
    return path


def applied(path: Path) -> set[str]:
    with closing(sqlite3.connect(f"{path.as_uri()}?mode=ro", uri=True)) as db:
        assert db.execute("PRAGMA integrity_check").fetchall() == [("ok",)]
        return {str(row[0]) for row in db.execute("SELECT name FROM _sqlite_migrations")}


def check_opened(path: Path) -> None:
    """Opens the file with the release in use, and looks for the work."""
    with open_store(path) as store:
        assert store.notice is None
        (group,) = store.groups.all()
        (program,) = store.programs.of_group(group.id)
        newest = store.versions.newest(program.id)
        assert newest is not None
        assert newest.workspace == {"text": "last"}


@pytest.mark.parametrize("stride", [5, pytest.param(1, marks=pytest.mark.nightly)])
def test_a_kill_in_the_middle_of_an_update_is_harmless(
    stride: int, work: Path, tmp_path: Path, updates: Updates, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = shutil.copytree(work.parent, tmp_path / "whole") / "pinel.db"
    n_steps = updates.start(whole)["n_steps"]
    print(f"{n_steps} steps")
    states = set()
    for step in range(1, n_steps + 1, stride):
        path = shutil.copytree(work.parent, tmp_path / str(step)) / "pinel.db"
        assert updates.start(path, step)["killed"]
        before = shutil.copytree(path.parent, tmp_path / f"{step} before") / "pinel.db"
        steps_done = applied(path) & NEXT_MIGRATIONS.keys()
        states.add(len(steps_done))
        backups = list_backups(path)
        assert all(damage_of(backup.path) is None for backup in backups)
        if steps_done:
            assert [applied(backup.path) for backup in backups] == [set(MIGRATIONS)]
            assert code_of(partial(open_store, before)) == "database_newer"
        else:
            check_opened(before)  # the release before the update
        with monkeypatch.context() as next_release:
            for name, statements in NEXT_MIGRATIONS.items():
                next_release.setitem(MIGRATIONS, name, statements)
            check_opened(path)
        shutil.rmtree(path.parent)
        shutil.rmtree(before.parent)
    assert states == {0, 1, 2, 3}
