"""The album of a group: what its runs win, what a merge brings, and what nothing takes away."""

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.activities import activity_names, solution_of
from pinel_desktop.school.album import N_CAREFUL, Sticker, album_of
from storage import RunStart, Store, open_store
from storage.limits import N_FEATURES
from storage.row_types import GroupRow
from tests.storage.bundle_makers import exported, merged, removed
from tests.storage.sample_documents import WORLD

OpenPc = Callable[[str], Store]
HAND = bytes(2 * N_FEATURES)
BACK_AND_FORTH: dict[str, Any] = {
    "pinel_ir": 1,
    "name": "p",
    "functions": [],
    "commands": [
        {"action": "move_forward", "distance": 3},
        {"action": "move_backward", "distance": 3},
    ],
}


@pytest.fixture
def pc(tmp_path: Path) -> Iterator[OpenPc]:
    with ExitStack() as stack:
        yield lambda name: stack.enter_context(open_store(tmp_path / f"{name}.db"))


@pytest.fixture
def store(pc: OpenPc) -> Store:
    return pc("here")


@pytest.fixture
def group(store: Store) -> GroupRow:
    return store.groups.create("Os Tatus")


def run(
    store: Store,
    group: GroupRow,
    activity: str | None,
    passed: bool | None,
    *,
    document: dict[str, Any] | None = None,
    state: str = "finished",
    path_m: float = 0.0,
) -> str:
    """Records an ended run of a new program; returns its id."""
    program = store.programs.create(group.id, "P")
    version = store.versions.save(program.id, {}, document or solution_of(str(activity)) or {})
    start = RunStart("sim", "w", WORLD, 1, "1", version_id=version.id, activity=activity)
    run_id = store.runs.begin(start).id
    values = [state, passed, path_m, run_id]
    store._database.write(
        lambda db: (
            db.execute(
                """UPDATE runs SET state = ?, passed = ?, path_length_m = ?, ended_at = started_at, duration_s = 1,
               check_report = '{"cases": []}' WHERE id = ?""",
                values,
            ).rowcount
        )
    )
    return run_id


def sticker(store: Store, group: GroupRow, name: str) -> Sticker:
    (found,) = [one for one in album_of(store, group.id, "pt-BR") if one.name == name]
    return found


def winner(store: Store, group: GroupRow, name: str) -> str | None:
    """The run that won a sticker, None for an empty place."""
    win = sticker(store, group, name).win
    return win.run_id if win else None


def won(store: Store, group: GroupRow) -> set[str]:
    return {one.name for one in album_of(store, group.id, "pt-BR") if one.win}


def test_an_album_without_runs_has_a_place_for_each_mission_along_the_paths(
    store: Store, group: GroupRow
) -> None:
    album = album_of(store, group.id, "pt-BR")
    assert [one.name for one in album if one.kind == "mission"] == activity_names()
    assert [one.name for one in album if one.kind == "character"] == [
        "repair",
        "shorter",
        "careful",
        "taught",
    ]
    assert won(store, group) == set()
    assert album[0].title == "Até a padaria"
    assert album_of(store, group.id, "en")[0].title == "To the bakery"


def test_the_first_run_that_passes_a_mission_wins_its_sticker(
    store: Store, group: GroupRow
) -> None:
    run(store, group, "square", None)
    assert won(store, group) == set()
    first = run(store, group, "square", True)
    run(store, group, "square", True)
    run(store, group, "square", False)
    assert winner(store, group, "square") == first
    assert won(store, group) == {"square"}


def test_a_mission_that_failed_and_passed_later_wins_the_repair(
    store: Store, group: GroupRow
) -> None:
    run(store, group, "square", False)
    run(store, group, "triangle", True)
    assert winner(store, group, "repair") is None
    repaired = run(store, group, "square", True)
    run(store, group, "triangle", False)
    run(store, group, "triangle", True)
    assert winner(store, group, "repair") == repaired


def test_fewer_blocks_than_the_solution_win_a_sticker_and_as_many_do_not(
    store: Store, group: GroupRow
) -> None:
    run(store, group, "bread_and_back", True)
    run(store, group, "bread_and_back", False, document=BACK_AND_FORTH)
    assert winner(store, group, "shorter") is None
    shorter = run(store, group, "bread_and_back", True, document=BACK_AND_FORTH)
    assert winner(store, group, "shorter") == shorter


def test_ten_runs_that_drove_and_finished_win_the_shield(store: Store, group: GroupRow) -> None:
    for _ in range(N_CAREFUL - 1):
        run(store, group, None, None, document=BACK_AND_FORTH, path_m=6.0)
    run(store, group, "square", False, path_m=2.0, state="failed")
    run(store, group, None, None, document=BACK_AND_FORTH, path_m=2.0, state="stopped")
    run(store, group, None, None, document=BACK_AND_FORTH, path_m=0.1)
    place = sticker(store, group, "careful")
    assert (place.win, place.n_done, place.n_needed) == (None, N_CAREFUL - 1, N_CAREFUL)
    tenth = run(store, group, None, None, document=BACK_AND_FORTH, path_m=6.0)
    run(store, group, None, None, document=BACK_AND_FORTH, path_m=6.0)
    assert winner(store, group, "careful") == tenth


def test_a_sign_taught_by_the_class_wins_a_sticker_that_a_change_of_class_does_not_take(
    store: Store,
) -> None:
    ninth, eighth = (store.classrooms.create(name).id for name in ("9º A", "8º A"))
    group = store.groups.create("Os Tatus", classroom_id=ninth)
    other = store.groups.create("Araras", classroom_id=eighth)
    run(store, group, "square", False)
    store.taught_signs.add(ninth, "robô", HAND)
    assert won(store, group) == {"taught"}
    assert won(store, other) == set()
    store.groups.change(group.id, {"classroom_id": eighth}, by_teacher=True)
    assert won(store, group) == {"taught"}


def test_an_activity_of_a_teacher_has_a_place_until_it_is_deleted_and_its_sticker_stays(
    store: Store, group: GroupRow
) -> None:
    key = store.own_activities.new_key()
    solution = {"commands": [{"action": "wait", "seconds": 1}] * 3}
    store.own_activities.save(key, "Até a porta", {"name": key, "solution": solution}, {})
    place = sticker(store, group, key)
    assert (place.kind, place.title, place.win) == ("own", "Até a porta", None)
    store.own_activities.delete(key)
    assert key not in {one.name for one in album_of(store, group.id, "pt-BR")}
    run(store, group, key, True, document=BACK_AND_FORTH)
    assert won(store, group) == {key, "shorter"}


def test_an_activity_of_a_newer_release_has_no_place(store: Store, group: GroupRow) -> None:
    run(store, group, "on_the_moon", True, document=BACK_AND_FORTH)
    assert won(store, group) == set()


def test_a_merge_brings_the_stickers_of_another_pc_once_their_runs_count(
    pc: OpenPc, tmp_path: Path
) -> None:
    there, here = pc("there"), pc("here")
    group = there.groups.create("Os Tatus")
    run(there, group, "square", False)
    passed = run(there, group, "square", True)
    here.exchange.merge(exported(there, tmp_path / "there.pinel").path)
    assert won(here, group) == set()
    here.unconfirmed.confirm(passed)
    assert won(here, group) == won(there, group) == {"square", "repair"}


def test_throwing_a_program_away_takes_no_sticker_and_deleting_its_runs_for_good_does(
    store: Store, group: GroupRow
) -> None:
    first, second = run(store, group, "square", True), run(store, group, "square", True)
    for program in store.programs.of_group(group.id):
        store.programs.move_to_bin(program.id)
    assert winner(store, group, "square") == first
    removed(store, first)
    assert winner(store, group, "square") == second
    removed(store, second)
    assert won(store, group) == set()


def test_the_album_of_a_merged_group_is_the_same_in_any_order_of_merges(
    pc: OpenPc, tmp_path: Path
) -> None:
    one, other = pc("one"), pc("other")
    group = one.groups.create("Os Tatus")
    merged(other, exported(one, tmp_path / "group.pinel").path)
    run(one, group, "square", True)
    run(other, group, "triangle", True)
    files = [exported(store, tmp_path / f"{n}.pinel").path for n, store in enumerate((one, other))]
    albums: list[list[Sticker]] = []
    for order in (files, files[::-1]):
        store = pc(f"teacher {len(albums)}")
        for file in order:
            merged(store, file)
        for waiting in store.unconfirmed.waiting():
            store.unconfirmed.confirm(waiting)
        albums.append(album_of(store, group.id, "pt-BR"))
    assert albums[0] == albums[1]
    assert {one.name for one in albums[0] if one.win} == {"square", "triangle"}
