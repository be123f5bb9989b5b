"""Passes of other PCs in a teacher's file of commit a15e9a7d, where approvals decided, in the present program."""

import json
from pathlib import Path

import pytest

from storage import open_store
from tests.attacks.forging import Pc
from tests.compatibility import archived_files as kept
from tests.compatibility.archived_files import DATABASE

THEN = json.loads((kept.FILES / "trust" / "runs.json").read_text("utf-8"))
RUNS = THEN["runs"]


@pytest.fixture
def home(tmp_path: Path) -> Path:
    return kept.unpack("trust", tmp_path / "home")


def test_what_counted_counts_and_what_waited_waits(home: Path) -> None:
    with open_store(home / DATABASE) as store:
        teacher = Pc(store, home)
        assert store.notice is None
        assert store.exchange.content_hash() == THEN["content_hash"]
        assert {name: teacher.mark(run) for name, run in RUNS.items()} == THEN["marks"]
        assert {name: teacher.counts(run) for name, run in RUNS.items()} == THEN["counts"]
        (room,) = [one.id for one in store.classrooms.all() if one.name == "8A"]
        assert [sign.sign for sign in store.taught_signs.of_classroom(room)] == ["oi"]


def test_a_pass_that_waited_is_repeated_here_and_a_forged_one_never_counts(home: Path) -> None:
    with open_store(home / DATABASE) as store:
        teacher = Pc(store, home)
        teacher.confirms()
        assert {name: teacher.counts(run) for name, run in RUNS.items()} == {
            **dict.fromkeys(RUNS, True),
            "forged": False,
            "forged and found": False,
        }


@pytest.mark.parametrize(("name", "n_runs"), [("approved", 3), ("teacher", 6)])
def test_a_signed_bundle_brings_what_it_holds(tmp_path: Path, name: str, n_runs: int) -> None:
    bundle = kept.unpack(f"trust/{name}.pinel", tmp_path / f"{name}.pinel")
    with open_store(tmp_path / "here" / "pinel.db") as store:
        assert store.exchange.merge(bundle).added["runs"] == n_runs
