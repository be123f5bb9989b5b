"""A correction on this PC wins on every other PC, whatever state of the row came before."""

from collections.abc import Callable
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest

from storage import Store
from storage.limits import MAX_REVISION
from storage.tables.replicated import REPLICATED
from storage.text import time_text
from tests.attacks.made_up_files import forged
from tests.storage.bundle_makers import Opened, exported, merged, work

REVISED = {t.name for t in REPLICATED if any(column.name == "revision" for column in t.columns)}
ACTIVITY = {"pinel_activity": 2, "name": "a", "title": {}, "checks": [], "cases": []}
GOAL: dict[str, object] = {"lines": [], "zones": [], "boxes": {}}
Correct = Callable[[Store, str], object]
CORRECTIONS: dict[str, Correct] = {
    "computers": lambda store, _: store.computers.rename("Sala 3"),
    "classrooms": lambda store, key: store.classrooms.rename(key, "5º C"),
    "groups": lambda store, key: store.groups.change(key, {"name": "Tucanos"}, by_teacher=True),
    "lessons": lambda store, key: store.lessons.change(key, {"title": "Círculos"}),
    "own_activities": lambda store, key: store.own_activities.save(
        key, "Até o fim", ACTIVITY, GOAL
    ),
    "calibrated_robots": lambda store, key: store.calibrated_robots.delete(key),
    "class_presets": lambda store, key: store.class_presets.set(key, {"level": 3}),
    "programs": lambda store, key: store.programs.rename(key, "Círculo"),
    "version_labels": lambda store, key: store.versions.label(key, "anda bem"),
    "notes": lambda store, key: store.notes.rewrite(key, "Quase!"),
    "truths": lambda store, _: store.truths.record(store.runs.newest(1)[0].id, "tape", []),
}
# by pupils, or by a lesson that is opened again: no other state for the order of corrections, but later than this one
REPEATED: dict[str, Correct] = {
    "groups": lambda store, key: store.groups.change(key, {"name": "Tucanos"}),
    "lessons": lambda store, _: store.lessons.open(
        store.classrooms.all()[0].id, "Quadrados", "to_the_door"
    ),
}
LATEST = time_text(datetime.now(UTC) + timedelta(days=1))
FARTHEST = "9998-01-01T00:00:00Z"


@pytest.fixture
def there(pc: Opened, tmp_path: Path) -> tuple[Store, Path]:
    """A store with a row of each table that has revisions, and a bundle of it."""
    store = pc("there")
    classroom = store.classrooms.create("5º B")
    store.lessons.open(classroom.id, "Quadrados")
    store.own_activities.save(store.own_activities.new_key(), "Até a porta", ACTIVITY, GOAL)
    store.calibrated_robots.create("Pioneer", "pioneer_3dx", {"track_m": 0.34}, {})
    store.class_presets.set(classroom.id, {"level": 2})
    _, run = work(store, store.groups.create("Onças", classroom_id=classroom.id), "Quadrado")
    store.truths.record(run, "tape", [(None, 1.0, 0.0, 0.0, 0.01, 0.03)])
    return store, exported(store, tmp_path / "there.pinel").path


def test_each_table_with_revisions_is_corrected_here() -> None:
    assert CORRECTIONS.keys() == REVISED


@pytest.mark.parametrize("corrections", [CORRECTIONS, REPEATED], ids=["revised", "repeated"])
@pytest.mark.parametrize("state", [(MAX_REVISION, LATEST), (MAX_REVISION - 1, FARTHEST)])
def test_a_correction_wins_over_the_latest_state_that_a_file_may_bring(
    there: tuple[Store, Path],
    pc: Opened,
    tmp_path: Path,
    state: tuple[int, str],
    corrections: dict[str, Correct],
) -> None:
    (store, file), (revision, time) = there, state
    forged(file, latest(revision, time))
    keys = {table: key_of(store, table) for table in corrections}
    assert merged(store, file).changed == dict.fromkeys(REVISED, 1)
    for table, correct in corrections.items():
        correct(store, keys[table])
    corrected = exported(store, tmp_path / "corrected.pinel")
    assert not corrected.left_out
    for name, files in {"a": (file, corrected.path), "b": (corrected.path, file)}.items():
        other = pc(name)
        for path in files:
            merged(other, path)
        for table, key in keys.items():
            assert row(other, table, key) == row(store, table, key), table


def latest(revision: int, time: str) -> str:
    """Statements that bring every row with revisions to a state."""
    return "".join(
        f"UPDATE {table} SET revision = {revision}, changed_at = '{time}';" for table in REVISED
    )


def key_of(store: Store, table: str) -> str:
    with store._database.read_connection() as db:
        (found,) = db.execute(f"SELECT id FROM {table}").fetchall()
    return str(found["id"])


def row(store: Store, table: str, key: str) -> tuple[object, ...]:
    with store._database.read_connection() as db:
        return tuple(db.execute(f"SELECT * FROM {table} WHERE id = ?", [key]).fetchone())
