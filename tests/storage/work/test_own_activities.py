"""Activities that a teacher made, what the groups of a class begin with, and the file that takes both to other PCs."""

from collections.abc import Callable
from pathlib import Path

import pytest

from storage import Store
from storage.exchange.bundle_reading import prepares_lesson
from storage.exchange.scope import Scope
from storage.limits import MAX_OWN_ACTIVITIES
from tests.storage.bundle_makers import exported, hash_of, merged, removed, work
from tests.storage.file.refusals import code_of

Opened = Callable[[Path], Store]
GOAL: dict[str, object] = {"lines": [], "zones": [], "boxes": {}}


def made(store: Store, title: str) -> str:
    """An activity of this title; returns its key."""
    key = store.own_activities.new_key()
    document = {"pinel_activity": 2, "name": key, "title": {}, "checks": [], "cases": []}
    store.own_activities.save(key, title, document, GOAL)
    return key


def titles(store: Store) -> list[str]:
    return [one.title for one in store.own_activities.all()]


@pytest.fixture
def fifth(store: Store) -> str:
    return store.classrooms.create("5º B").id


@pytest.fixture
def other(opened: Opened, tmp_path: Path) -> Store:
    return opened(tmp_path / "other.db")


def test_an_activity_is_changed_deleted_and_brought_back(store: Store) -> None:
    key = made(store, "Até a porta")
    made(store, "Volta")
    store.own_activities.save(key, " Até  a janela ", {"pinel_activity": 2, "name": key}, GOAL)
    assert titles(store) == ["Até a janela", "Volta"]
    store.own_activities.delete(key)
    assert titles(store) == ["Volta"]
    assert store.own_activities.get(key).document["name"] == key
    store.own_activities.undelete(key)
    assert titles(store) == ["Até a janela", "Volta"]


def test_what_cannot_be_kept_is_told(store: Store) -> None:
    unknown = lambda: store.own_activities.get("x")  # noqa: E731
    assert code_of(unknown) == "own_activity_not_found"
    assert code_of(lambda: store.own_activities.delete("x")) == "own_activity_not_found"
    assert code_of(lambda: made(store, " ")) == "name_empty"
    for i in range(MAX_OWN_ACTIVITIES):
        made(store, f"A{i}")
    assert code_of(lambda: made(store, "one more")) == "own_activities_too_many"


def test_of_two_states_the_later_is_kept_on_both_pcs(
    store: Store, other: Store, tmp_path: Path
) -> None:
    key = made(store, "Até a porta")
    merged(other, exported(store, tmp_path / "a.pinel").path)
    other.own_activities.save(key, "Até a mesa", {"pinel_activity": 2, "name": key}, GOAL)
    other.own_activities.delete(key)
    bundles = [exported(one, tmp_path / f"{i}.pinel").path for i, one in enumerate((store, other))]
    merged(store, bundles[1])
    merged(other, bundles[0])
    assert titles(store) == titles(other) == []
    assert store.own_activities.get(key).title == "Até a mesa"
    assert hash_of(store) == hash_of(other)


def test_a_file_without_them_has_the_hash_that_it_had(store: Store, fifth: str) -> None:
    before = hash_of(store)
    store.class_presets.set(fifth, {})  # nothing is set: no row is made
    assert hash_of(store) == before
    made(store, "Até a porta")
    assert hash_of(store) != before


def test_they_go_with_their_class_and_with_work_that_names_them(
    store: Store, fifth: str, tmp_path: Path
) -> None:
    used = made(store, "Usada")
    made(store, "Outra")
    group = store.groups.create("Onças", classroom_id=fifth)
    program, _ = work(store, group, "P")
    store.versions.save(program.id, {"n": 3}, None, setup={"activity": used})
    scopes = {
        "all": (Scope(), 2),
        "class": (Scope(classroom_id=fifth), 2),
        "group": (Scope(group_id=group.id), 1),
        "program": (Scope(program_id=program.id), 1),
    }
    for name, (scope, n) in scopes.items():
        counts = exported(store, tmp_path / f"{name}.pinel", scope).counts
        assert counts["own_activities"] == n, name


def test_an_anonymous_file_has_none_of_their_texts(store: Store, tmp_path: Path) -> None:
    made(store, "A casa da Ana")
    path = store.exchange.export(
        tmp_path / "x.pinel", app_version="1", computer=("", ""), anonymous=[]
    ).path
    assert b"casa da Ana" not in path.read_bytes()


def test_the_preset_of_a_class_is_its_last_and_goes_with_the_class(
    store: Store, fifth: str, other: Store, tmp_path: Path
) -> None:
    assert store.class_presets.get(fifth) == {}
    store.class_presets.set(fifth, {"level": 2})
    store.class_presets.set(fifth, {"level": 3, "swap_minutes": 10})
    merged(other, exported(store, tmp_path / "a.pinel", Scope(classroom_id=fifth)).path)
    assert other.class_presets.get(fifth) == {"level": 3, "swap_minutes": 10}
    removed(store, fifth)
    assert code_of(lambda: store.class_presets.get(fifth)) == "classroom_not_found"
    merged(other, exported(store, tmp_path / "b.pinel").path)
    assert hash_of(store) == hash_of(other)


@pytest.fixture
def lesson_file(store: Store, fifth: str, tmp_path: Path) -> Path:
    """The file of a lesson of a class that has worked before."""
    group = store.groups.create("Onças", classroom_id=fifth)
    program, _ = work(store, group, "P")
    store.programs.rename(program.id, "Segredo")
    store.class_presets.set(fifth, {"swap_minutes": 10})
    key = made(store, "Até a porta")
    lesson = store.lessons.open(fifth, "Robôs", key)
    scope = Scope(classroom_id=fifth, lesson_id=lesson.id)
    return exported(store, tmp_path / "lesson.pinel", scope).path


def test_the_file_of_a_lesson_has_no_work_and_says_that_it_is_one(
    store: Store, lesson_file: Path, other: Store, tmp_path: Path
) -> None:
    report = merged(other, lesson_file)
    assert report.info.lesson_id == store.lessons.of_classroom(_class(store))[0].id
    assert report.added.keys() == {
        *("computers", "classrooms", "groups", "lessons", "own_activities", "class_presets")
    }
    assert b"Segredo" not in lesson_file.read_bytes()
    assert prepares_lesson(lesson_file)
    assert not prepares_lesson(exported(store, tmp_path / "all.pinel").path)
    assert not prepares_lesson(tmp_path / "nowhere.pinel")


def _class(store: Store) -> str:
    return store.classrooms.all()[0].id


def test_the_lesson_is_opened_on_the_other_pc_and_once_more_changes_nothing(
    store: Store, lesson_file: Path, other: Store, tmp_path: Path
) -> None:
    lesson = str(merged(other, lesson_file).info.lesson_id)
    assert other.lessons.current(_class(other)) is None
    opened = other.lessons.resume(lesson)
    assert (opened.title, opened.closed_at) == ("Robôs", None)
    found = other.lessons.current(_class(other))
    assert found is not None
    assert found.id == lesson
    before = hash_of(other)
    assert merged(other, lesson_file).nothing_new
    other.lessons.resume(lesson)
    assert hash_of(other) == before
    assert merged(store, exported(other, tmp_path / "back.pinel").path).changed.keys() <= {
        "lessons"
    }


def test_a_lesson_of_the_file_closes_what_was_open(
    store: Store, lesson_file: Path, other: Store
) -> None:
    lesson = str(merged(other, lesson_file).info.lesson_id)
    before = other.lessons.open(_class(other), "Outra")
    other.lessons.resume(lesson)
    assert other.lessons.get(before.id).closed_at is not None
    group = other.groups.all()[0]
    program = other.programs.create(group.id, "Novo")
    assert other.versions.save(program.id, {}, None).lesson_id == lesson
    assert code_of(lambda: other.lessons.resume("x")) == "lesson_not_found"
