"""Runs whose document grows while they are live: it is in the row until a version holds it."""

from collections.abc import Callable

import pytest

from storage import ProgramRow, RunStart, Store, StoreError
from tests.storage.sample_documents import SQUARE, WORLD

GROWN = {**SQUARE, "commands": [*SQUARE["commands"], {"action": "stop"}]}


def start_in(program_id: str) -> RunStart:
    return RunStart("sim", "empty_room", WORLD, 7, "0.1.0", document=SQUARE, program_id=program_id)


def test_it_is_listed_with_its_program_and_gets_a_version_in_the_end(
    store: Store, program: ProgramRow
) -> None:
    run = store.runs.begin(start_in(program.id))
    assert (run.group_id, run.program_name) == (program.group_id, "Quadrado")
    store.runs.update_document(run.id, GROWN)
    assert store.runs.get(run.id).document == GROWN
    version = store.versions.save(program.id, {}, GROWN)
    store.runs.attach_version(run.id, version.id)
    store.runs.update_document(run.id, SQUARE)  # too late
    settled = store.runs.get(run.id)
    assert (settled.version_id, settled.document) == (version.id, None)


def test_what_a_crash_leaves_has_the_newest_document(
    opened: Callable[..., Store], store: Store, program: ProgramRow
) -> None:
    run = store.runs.begin(start_in(program.id))
    store.runs.update_document(run.id, GROWN)
    store.close()
    store = opened(close_interrupted=True)
    left = store.runs.get(run.id)
    assert (left.reason, left.document, left.version_id) == ("interrupted", GROWN, None)
    assert [one.id for one in store.runs.of_group(program.group_id)] == [run.id]


def test_its_program_must_be_there(store: Store) -> None:
    with pytest.raises(StoreError, match="program_not_found"):
        store.runs.begin(start_in("nobody"))
