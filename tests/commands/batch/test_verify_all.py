"""`pinel runs verify --all`: every run of a store, on any workers, in the order of the ids."""

import json
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

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


def test_empty_store_has_nothing_to_verify(home: Path) -> None:
    open_store(home / "pinel.db").close()
    assert verified() == (0, [])


def test_run_or_all(ids: list[str]) -> None:
    assert pinel("runs", "verify").exit_code == 2
    assert pinel("runs", "verify", ids[0], "--all").exit_code == 2
    assert pinel("runs", "verify", "--all", "--workers", "2", "--dask", "tcp://a:1").exit_code == 2


def test_cluster_that_cannot_be_used_is_named(ids: list[str]) -> None:
    done = pinel("runs", "verify", "--all", "--dask", "nowhere")
    assert done.exit_code == 2
    assert "no address of a Dask cluster" in done.stderr
    assert "0 of 3 runs were verified" in done.stderr
