"""What pupils may bring in: one program, and of it only what is not there yet."""

import json
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest

from storage import Store, StoreError
from storage.exchange.bundle_writing import counts_of
from storage.exchange.content_hash import content_hash
from storage.exchange.scope import Scope
from storage.sqlite import sqlite3
from tests.storage.bundle_makers import (
    a_run,
    exported,
    hash_of,
    merged,
    problems_in,
    removed,
    work,
)

POISON = (
    "UPDATE classrooms SET name = 'X', revision = 999",
    "UPDATE groups SET name = 'X', name_key = 'x', revision = 999",
    "UPDATE lessons SET title = 'X', revision = 999",
    "UPDATE computers SET name = 'X', revision = 999",
    "UPDATE programs SET name = 'X', revision = 999, deleted_at = '2026-01-01T00:00:00.000Z'",
    "UPDATE version_labels SET text = 'X', revision = 999",
    "UPDATE runs SET world = 'zzz', passed = 1",
    'UPDATE events SET data = \'{"text":"zzz"}\'',
    "UPDATE notes SET text = 'X', revision = 999",
)


def changed(path: Path, *statements: str) -> Path:
    """The bundle after somebody has changed it, with a checksum that fits."""
    with closing(sqlite3.connect(path, isolation_level=None)) as db:
        for statement in statements:
            db.execute(statement)
        values = [content_hash(db), json.dumps(counts_of(db))]
        db.execute("UPDATE bundle SET content_hash = ?, counts = ?", values)
    return path


def test_of_a_group_the_newest_program_outside_the_bin_is_opened(
    pc: Callable[[str], Store], tmp_path: Path
) -> None:
    here, there = pc("a"), pc("b")
    group = there.groups.create("Onças")
    program, _ = work(there, group, "Quadrado")
    newest, _ = work(there, group, "Triângulo")
    there.programs.move_to_bin(newest.id)
    path = exported(there, tmp_path / "g.pinel", Scope(group_id=group.id)).path
    assert here.exchange.merge_program(path)[1] == program.id


def test_it_comes_with_all_that_it_needs_but_the_notes(
    pc: Callable[[str], Store], tmp_path: Path
) -> None:
    here, there = pc("a"), pc("b")
    classroom = there.classrooms.create("5º B")
    there.lessons.open(classroom.id, "Aula")
    program, run_id = work(
        there, there.groups.create("Onças", classroom_id=classroom.id), "Quadrado"
    )
    path = exported(there, tmp_path / "p.pinel", Scope(program_id=program.id)).path
    report, program_id = here.exchange.merge_program(path)
    assert (program_id, report.added["versions"], report.added["runs"]) == (program.id, 2, 1)
    assert here.programs.get(program.id).name == "Quadrado"
    assert here.runs.get(run_id) == there.runs.get(run_id)
    assert here.runs.events(run_id) == there.runs.events(run_id)
    assert here.runs.telemetry(run_id).to_wire() == there.runs.telemetry(run_id).to_wire()
    assert "notes" not in report.added
    assert here.exchange.merge_program(path)[0].nothing_new
    assert problems_in(here.path) == []
    assert merged(here, path).added == {"notes": 1}
    assert hash_of(here) == hash_of(there)


@pytest.mark.parametrize("statement", POISON)
def test_nothing_that_is_here_changes(
    pc: Callable[[str], Store], tmp_path: Path, statement: str
) -> None:
    store = pc("a")
    classroom = store.classrooms.create("5º B")
    store.lessons.open(classroom.id, "Aula")
    group = store.groups.create("Onças", classroom_id=classroom.id)
    program, _ = work(store, group, "Quadrado")
    path = exported(store, tmp_path / "p.pinel", Scope(program_id=program.id)).path
    before = hash_of(store)
    report, _ = store.exchange.merge_program(changed(path, statement))
    assert (report.nothing_new, hash_of(store)) == (True, before)


def test_what_is_not_of_the_program_stays_out(pc: Callable[[str], Store], tmp_path: Path) -> None:
    here, there = pc("a"), pc("b")
    group, other = (there.groups.create(name) for name in ("Onças", "Araras"))
    program, _ = work(there, group, "Quadrado")
    theirs, _ = work(there, other, "Outro")
    a_run(there, None)
    path = exported(there, tmp_path / "all.pinel").path
    with pytest.raises(StoreError) as caught:
        here.exchange.merge_program(path)
    assert caught.value.code == "bundle_not_program"
    of_theirs = f"(SELECT id FROM versions WHERE program_id = '{theirs.id}')"
    changed(
        path,
        "DELETE FROM notes",
        f"DELETE FROM version_labels WHERE id IN {of_theirs}",
        f"UPDATE runs SET version_id = NULL, program_id = NULL WHERE program_id = '{theirs.id}'",
        f"DELETE FROM versions WHERE program_id = '{theirs.id}'",
        f"DELETE FROM programs WHERE id = '{theirs.id}'",
    )
    here.exchange.merge_program(path)
    assert [found.id for found in here.groups.all()] == [group.id]
    assert {run.program_id for run in here.runs.newest(9)} == {program.id}
    assert problems_in(here.path) == []


def test_one_that_was_deleted_stays_away(pc: Callable[[str], Store], tmp_path: Path) -> None:
    store = pc("a")
    group = store.groups.create("Onças")
    program, _ = work(store, group, "Quadrado")
    path = exported(store, tmp_path / "p.pinel", Scope(program_id=program.id)).path
    removed(store, group.id)
    before = hash_of(store)
    assert store.exchange.merge_program(path)[0].nothing_new
    assert hash_of(store) == before
