"""`pinel runs verify --all`: every run of a store, on any workers, in the order of the ids."""

import json
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.commands.batch.verify_all import Found, _Task, _verify
from storage import RunStart, open_store
from storage.sqlite import sqlite3
from tests.commands.typed import PROGRAMS, SQUARE, pinel, run_json


def verified(*options: str) -> tuple[int, list[dict[str, Any]]]:
    done = pinel("runs", "verify", "--all", "--json", *options)
    return done.exit_code, [json.loads(line) for line in done.stdout.splitlines()]


@pytest.fixture
def ids(home: Path) -> list[str]:
    """Three runs of the simulator."""
    files = (SQUARE, str(PROGRAMS / "triangle.json"), SQUARE)
    return [run_json(file, "--preset", "realistic")[1]["run_id"] for file in files]


def test_all_runs_are_verified_in_their_order_on_one_process_and_on_two(ids: list[str]) -> None:
    status, alone = verified("--workers", "1")
    assert status == 0
    assert [one["run"] for one in alone] == sorted(ids)
    assert [one["outcome"] for one in alone] == ["identical"] * 3
    assert verified("--workers", "2") == (0, alone)


def test_changed_run_is_found_among_the_others(ids: list[str], home: Path) -> None:
    with closing(sqlite3.connect(home / "pinel.db")) as db, db:
        db.execute("UPDATE runs SET path_length_m = 1 WHERE id = ?", [ids[1]])
    status, found = verified("--workers", "1")
    assert status == 1
    assert {one["run"]: one["outcome"] for one in found}[ids[1]] in ("altered", None)
    assert [one["outcome"] for one in found].count("identical") == 2


def test_runs_that_cannot_be_repeated_are_named_and_no_fault(ids: list[str], home: Path) -> None:
    with open_store(home / "pinel.db") as store:
        row = store.runs.get(ids[0])
        store.runs.begin(
            RunStart("sim", row.world, row.world_document, 0, "0.2.0", document=row.document)
        )
    done = pinel("runs", "verify", "--all", "--workers", "1")
    assert done.exit_code == 0
    assert done.stdout.splitlines()[-1] == "3 identical, 1 run_not_ended"


def test_lines_of_a_file_are_those_that_are_printed(ids: list[str], tmp_path: Path) -> None:
    out = tmp_path / "verified.jsonl"
    done = pinel("runs", "verify", "--all", "--workers", "1", "--out", str(out))
    assert (done.exit_code, done.stdout) == (0, "3 identical\n")
    assert [json.loads(line) for line in out.read_text("utf-8").splitlines()] == verified()[1]
    assert not list(tmp_path.glob("*.rows"))
    again = pinel("runs", "verify", "--all", "--out", str(out))
    assert again.exit_code == 2
    assert "exists already" in again.stderr


def test_a_verification_that_ended_early_goes_on_without_a_run_twice(
    ids: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out, journal = tmp_path / "verified.jsonl", tmp_path / "verified.jsonl.rows"
    repeated: list[str] = []

    def interrupted_after(n: int) -> None:
        def verify(task: _Task) -> Found:
            if len(repeated) == n:
                raise KeyboardInterrupt
            repeated.append(task.id)
            return _verify(task)

        monkeypatch.setattr("pinel_desktop.commands.batch.verify_all._verify", verify)

    arguments = ("runs", "verify", "--all", "--workers", "1", "--out", str(out))
    interrupted_after(2)
    stopped = pinel(*arguments)
    assert stopped.exit_code == 130
    assert "2 of 3 runs are done" in stopped.stderr
    assert not out.exists()
    with journal.open("ab") as torn:
        torn.write(b'{"run": "torn by a ki')
    interrupted_after(4)
    assert pinel(*arguments).exit_code == 0
    assert repeated == sorted(ids)
    assert [json.loads(line)["run"] for line in out.read_text("utf-8").splitlines()] == sorted(ids)


def test_lines_of_another_database_are_refused_and_stay(ids: list[str], tmp_path: Path) -> None:
    out, journal = tmp_path / "verified.jsonl", tmp_path / "verified.jsonl.rows"
    journal.write_bytes(b'{"pinel_sweep": "of another database"}\n')
    done = pinel("runs", "verify", "--all", "--workers", "1", "--out", str(out))
    assert done.exit_code == 2
    assert journal.read_bytes() == b'{"pinel_sweep": "of another database"}\n'


def test_empty_store_has_nothing_to_verify(home: Path) -> None:
    open_store(home / "pinel.db").close()
    assert verified() == (0, [])


def test_run_or_all(ids: list[str]) -> None:
    assert pinel("runs", "verify").exit_code == 2
    assert pinel("runs", "verify", ids[0], "--all").exit_code == 2
    assert pinel("runs", "verify", ids[0], "--out", "x").exit_code == 2
    assert pinel("runs", "verify", "--all", "--workers", "2", "--dask", "tcp://a:1").exit_code == 2


def test_cluster_that_cannot_be_used_is_named(ids: list[str]) -> None:
    done = pinel("runs", "verify", "--all", "--dask", "nowhere")
    assert done.exit_code == 2
    assert "no address of a Dask cluster" in done.stderr
    assert "0 of 3 runs were verified" in done.stderr
