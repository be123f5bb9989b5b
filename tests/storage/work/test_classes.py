"""Classes, groups in them, lessons, notes, the bin, and the line of a program's versions."""

from functools import partial
from pathlib import Path
from typing import Any

import pytest

from storage import GroupRow, ProgramRow, RunStart, Store, open_store
from storage.choices import COLORS, PATTERNS, PICTURES
from storage.work.groups import Appearance
from tests.storage.bundle_makers import exported, hash_of, merged
from tests.storage.file.refusals import code_of
from tests.storage.sample_documents import WORLD
from tests.storage.work.school_clock import SchoolClock


@pytest.fixture
def clock() -> SchoolClock:
    return SchoolClock()


@pytest.fixture
def school(path: Path, clock: SchoolClock) -> Any:
    with open_store(path, clock=clock, uptime=clock.uptime) as store:
        yield store


def edited(school: Store, program: ProgramRow, text: str) -> str:
    return school.versions.save(program.id, {"text": text}, {"commands": []}).id


def run_of(school: Store, version_id: str) -> str:
    start = RunStart("sim", "empty_room", WORLD, 0, "1", version_id=version_id)
    return school.runs.begin(start).id


def test_classes_are_by_name_with_the_number_of_their_groups(school: Store, ninth: str) -> None:
    tenth = school.classrooms.create("10º")
    school.groups.create("A", classroom_id=tenth.id)
    school.classrooms.create("1º")
    assert [(row.name, row.n_groups) for row in school.classrooms.all()] == [
        ("1º", 0),
        ("9º A", 0),
        ("10º", 1),
    ]
    assert code_of(lambda: school.classrooms.create("9ºa")) == "classroom_exists"
    assert school.classrooms.rename(ninth, "9º B").name == "9º B"
    assert school.classrooms.rename(ninth, "9º b").name == "9º b"
    assert code_of(lambda: school.classrooms.rename(tenth.id, " 9º B")) == "classroom_exists"
    assert code_of(lambda: school.classrooms.rename("x", "C")) == "classroom_not_found"


def test_a_name_of_a_group_is_free_in_another_class(school: Store, robots: GroupRow) -> None:
    other = school.classrooms.create("9º B").id
    same = school.groups.create("os robôs", classroom_id=other)
    again = school.groups
    assert code_of(lambda: again.create("OS ROBÔS", classroom_id=other)) == "group_exists"
    assert code_of(lambda: again.create("A", classroom_id="x")) == "classroom_not_found"
    moving = {"classroom_id": robots.classroom_id}
    assert code_of(lambda: again.change(same.id, moving)) == "group_exists"
    assert again.change(same.id, {"name": "B", **moving}).classroom_id == robots.classroom_id


def test_groups_of_a_class_differ_in_picture_and_colour(school: Store, ninth: str) -> None:
    made = [school.groups.create(f"Grupo {n}", classroom_id=ninth) for n in range(12)]
    assert len({group.picture for group in made}) == len({group.color for group in made}) == 12
    changed = school.groups.change(made[0].id, {"picture": PICTURES[-1], "color": COLORS[-1]})
    assert (changed.picture, changed.color, changed.name) == (PICTURES[-1], COLORS[-1], "Grupo 0")
    assert code_of(lambda: school.groups.change(changed.id, {"color": "red"})) == "color_unknown"
    foreign = Appearance(picture="../x")
    assert code_of(lambda: school.groups.create("Z", appearance=foreign)) == "picture_unknown"
    assert code_of(lambda: school.groups.change("x", {"name": "Y"})) == "group_not_found"


def test_no_two_robots_of_a_class_look_alike_unless_groups_choose_so(
    school: Store, ninth: str
) -> None:
    made = [school.groups.create(f"Grupo {n}", classroom_id=ninth) for n in range(24)]
    assert {group.robot_pattern for group in made[:6]} == set(PATTERNS)
    assert {group.color for group in made[:12]} == set(COLORS)
    assert len({(group.color, group.robot_pattern) for group in made}) == 24
    same = Appearance(made[0].color, made[0].picture, "Faísca", made[0].robot_pattern)
    chosen = school.groups.create("Iguais", classroom_id=ninth, appearance=same)
    assert (chosen.color, chosen.picture) == (made[0].color, made[0].picture)
    assert (chosen.robot_name, chosen.robot_pattern) == ("Faísca", made[0].robot_pattern)


def test_a_pattern_that_a_robot_has_in_the_same_colour_is_given_last(
    school: Store, ninth: str
) -> None:
    create = partial(school.groups.create, classroom_id=ninth)
    create("A", appearance=Appearance(COLORS[0], robot_pattern="waves"))
    for number, pattern in enumerate(2 * [one for one in PATTERNS if one != "waves"]):
        create(f"B{number}", appearance=Appearance(COLORS[1], robot_pattern=pattern))
    assert create("C", appearance=Appearance(COLORS[0])).robot_pattern != "waves"


@pytest.mark.parametrize(
    ("name", "color", "pattern"),
    [("Botos", 8, "checks"), ("ARARAS ", 5, "dots"), ("Onças", 0, "checks"), ("🤖", 2, "plain")],
)
def test_the_name_of_the_first_group_decides_as_on_the_page(
    school: Store, name: str, color: int, pattern: str
) -> None:
    """`ui/src/work/livery/appearance.test.ts` has the same table."""
    group = school.groups.create(name)
    assert (COLORS.index(group.color), group.robot_pattern) == (color, pattern)


def test_a_robot_has_a_name_and_a_pattern_of_the_list(school: Store, ninth: str) -> None:
    group = school.groups.create("Botos", classroom_id=ninth)
    assert group.robot_name == ""
    change = partial(school.groups.change, group.id)
    for given, stored in {
        "  Faísca\u202e ": "Faísca",
        "🤖" * 60: "🤖" * 60,
        "برق": "برق",
        "\u200b": "",
        "": "",
    }.items():
        assert change({"robot_name": given}).robot_name == stored
    assert code_of(lambda: change({"robot_name": "x" * 61})) == "name_too_long"
    assert change({"robot_pattern": "star"}).robot_pattern == "star"
    assert code_of(lambda: change({"robot_pattern": "tartan"})) == "pattern_unknown"


def test_a_class_is_told_from_another_of_its_name_by_the_pc_of_its_first_lesson(
    school: Store, ninth: str
) -> None:
    school.computers.rename("PC 7")
    assert school.classrooms.get(ninth).computer is None
    school.lessons.open(ninth, "Quadrados")
    assert school.classrooms.get(ninth).computer == "PC 7"
    assert school.classrooms.all()[0].computer == "PC 7"


def test_what_is_thrown_away_comes_back_from_the_bin(
    school: Store, robots: GroupRow, square: ProgramRow
) -> None:
    version_id = edited(school, square, "a")
    assert school.programs.move_to_bin(square.id).deleted_at is not None
    assert school.programs.of_group(robots.id) == []
    group = school.groups.get(robots.id)
    assert (group.n_programs, group.n_in_bin) == (0, 1)
    assert [row.id for row in school.programs.of_group(robots.id, in_bin=True)] == [square.id]
    assert school.programs.restore_from_bin(square.id).deleted_at is None
    assert school.programs.of_group(robots.id, in_bin=True) == []
    newest = school.versions.newest(square.id)
    assert newest is not None
    assert newest.id == version_id


def test_the_line_of_versions_knows_what_came_of_what(school: Store, square: ProgramRow) -> None:
    first, second = edited(school, square, "a"), edited(school, square, "b")
    back = school.versions.save(square.id, {"text": "c"}, None, parent_id=first)
    school.versions.label(first, "  anda em   linha ")
    run_of(school, second)
    line = school.versions.history_of(square.id)
    assert [(mark.number, mark.parent_id, mark.label) for mark in line] == [
        (3, first, ""),
        (2, first, ""),
        (1, None, "anda em linha"),
    ]
    assert [(mark.can_run, mark.n_runs) for mark in line] == [(False, 0), (True, 1), (True, 0)]
    assert [mark.id for mark in school.versions.history_of(square.id, before=back.id, limit=1)] == [
        second
    ]
    assert school.versions.label(first, "").label == ""
    assert school.versions.get(back.id).parent_id == first
    assert code_of(lambda: school.versions.label("x", "a")) == "version_not_found"


def test_work_belongs_to_a_lesson_that_opens_by_itself(
    school: Store, clock: SchoolClock, ninth: str, square: ProgramRow
) -> None:
    edited(school, square, "a")
    clock.passes(minutes=40)
    run_of(school, edited(school, square, "b"))
    (lesson,) = school.lessons.of_classroom(ninth)
    assert (lesson.by_itself, lesson.title, lesson.n_versions, lesson.n_runs) == (True, "", 2, 1)
    assert lesson.computer == school.computers.this()[1]
    clock.passes(minutes=46)
    assert school.lessons.current(ninth) is None
    edited(school, square, "c")
    second, first = school.lessons.of_classroom(ninth)
    assert (first.id, first.closed_at is None) == (lesson.id, False)
    assert (second.n_versions, second.closed_at) == (1, None)


def test_a_clock_that_is_set_back_a_little_does_not_end_a_lesson(
    school: Store, clock: SchoolClock, ninth: str, square: ProgramRow
) -> None:
    edited(school, square, "a")
    clock.is_set(minutes=-30)
    edited(school, square, "b")
    assert [lesson.n_versions for lesson in school.lessons.of_classroom(ninth)] == [2]


def test_the_teacher_s_lesson_is_one_on_every_pc(
    school: Store, clock: SchoolClock, ninth: str, square: ProgramRow
) -> None:
    edited(school, square, "a")
    opened = school.lessons.open(ninth, "Aula 7: losango", "square")
    clock.passes(hours=2)
    edited(school, square, "b")
    assert school.lessons.open(ninth, "AULA 7: Losango").id == opened.id
    current = school.lessons.current(ninth)
    assert current is not None
    assert (current.id, current.n_versions, current.by_itself) == (opened.id, 1, False)
    assert school.lessons.close(opened.id).closed_at is not None
    assert school.lessons.current(ninth) is None
    assert {lesson.by_itself for lesson in school.lessons.of_classroom(ninth)} == {True, False}
    assert code_of(lambda: school.lessons.open(ninth, " ")) == "name_empty"


def test_a_lesson_that_was_deleted_for_good_is_another_when_its_title_comes_back(
    school: Store, ninth: str
) -> None:
    first = school.lessons.open(ninth, "Aula 7").id
    school.exchange.purge("lesson", first)
    second = school.lessons.open(ninth, "Aula 7").id
    assert second != first
    assert school.lessons.open(ninth, "aula 7").id == second


def test_lessons_of_one_class_can_be_joined(
    school: Store, clock: SchoolClock, ninth: str, square: ProgramRow
) -> None:
    edited(school, square, "a")
    by_itself = school.lessons.of_classroom(ninth)[0].id
    clock.passes(hours=1)
    opened = school.lessons.open(ninth, "Aula 8").id
    change = school.lessons.change
    assert change(by_itself, {"part_of": opened}).part_of == opened
    assert school.lessons.parts(opened) == [opened, by_itself]
    other = school.lessons.open(school.classrooms.create("B").id, "Aula 8").id
    for lesson, to in ((opened, opened), (opened, by_itself), (by_itself, other), (opened, other)):
        assert code_of(lambda a=lesson, b=to: change(a, {"part_of": b})) == "lesson_not_joinable"  # type: ignore[misc]
    assert code_of(lambda: change(opened, {"part_of": "x"})) == "lesson_not_found"
    assert change(by_itself, {"part_of": None, "title": "Aula 9"}).title == "Aula 9"


def test_a_note_is_new_to_its_group_until_it_is_seen(
    school: Store, robots: GroupRow, square: ProgramRow
) -> None:
    run_id = run_of(school, edited(school, square, "a"))
    note = school.notes.write(run_id, "  Por que girou 90°? \n\ud800 ")
    assert (note.text, note.program_name) == ("Por que girou 90°?", "Quadrado")
    assert school.notes.of_group(robots.id, unseen=True) == school.notes.of_run(run_id) == [note]
    assert school.notes.acknowledge(note.id).seen_at is not None
    assert school.notes.of_group(robots.id, unseen=True) == []
    assert school.notes.rewrite(note.id, "Outra").seen_at is None
    assert code_of(lambda: school.notes.write(run_id, " \n")) == "note_empty"
    assert code_of(lambda: school.notes.write(run_id, "a" * 1001)) == "note_too_long"
    assert code_of(lambda: school.notes.write("x", "a")) == "run_not_found"
    assert code_of(lambda: school.notes.acknowledge("x")) == "note_not_found"


def merged_in_both_orders(folder: Path, one: Store, other: Store) -> list[Store]:
    """The states of two PCs in two fresh files; they hold the same."""
    bundles = [exported(pc, folder / f"{n}.pinel").path for n, pc in enumerate((one, other))]
    stores = []
    for n, order in enumerate((bundles, bundles[::-1])):
        store = open_store(folder / f"merged{n}.db")
        for bundle in order:
            merged(store, bundle)
        stores.append(store)
    assert hash_of(stores[0]) == hash_of(stores[1])
    return stores


@pytest.mark.parametrize("ahead", [1, -1])
def test_the_teacher_s_change_beats_what_pupils_did_on_the_older_state(
    school: Store,
    robots: GroupRow,
    square: ProgramRow,
    clock: SchoolClock,
    tmp_path: Path,
    ahead: int,
) -> None:
    first = school.lessons.open(str(robots.classroom_id), "Aula 1").id
    lesson = school.lessons.open(str(robots.classroom_id), "Aula 2").id
    note = school.notes.write(run_of(school, edited(school, square, "a")), "Muito bem").id
    school.close_interrupted()
    other = school.classrooms.create("9º B").id
    with open_store(tmp_path / "teacher.db", clock=clock, uptime=clock.uptime) as teacher:
        merged(teacher, exported(school, tmp_path / "b.pinel").path)
        teacher.notes.rewrite(note, "Por quê?")
        teacher.lessons.change(lesson, {"title": "Losango", "part_of": first})
        teacher.groups.change(robots.id, {"classroom_id": other}, by_teacher=True)
        clock.passes(days=1)
        clock.is_set(days=ahead - 1)
        school.notes.acknowledge(note)
        for color in COLORS[-2:]:
            school.groups.change(robots.id, {"color": color, "name": "Gatos"})
        edited(school, square, "b")
        assert school.lessons.get(lesson).closed_at is not None
        stores = merged_in_both_orders(tmp_path, school, teacher)
    for store in stores:
        with store:
            assert (store.notes.get(note).text, store.notes.get(note).seen_at) == ("Por quê?", None)
            merged_lesson = store.lessons.get(lesson)
            assert (merged_lesson.title, merged_lesson.part_of) == ("Losango", first)
            assert store.groups.get(robots.id).classroom_id == other


@pytest.mark.parametrize("ahead", [1, -1])
def test_what_pupils_did_is_kept_where_the_teacher_changed_nothing(
    school: Store,
    robots: GroupRow,
    square: ProgramRow,
    clock: SchoolClock,
    tmp_path: Path,
    ahead: int,
) -> None:
    lesson = school.lessons.open(str(robots.classroom_id), "Aula 1").id
    note = school.notes.write(run_of(school, edited(school, square, "a")), "Muito bem").id
    school.close_interrupted()
    with open_store(tmp_path / "teacher.db", clock=clock, uptime=clock.uptime) as teacher:
        merged(teacher, exported(school, tmp_path / "b.pinel").path)
        clock.passes(days=1)
        clock.is_set(days=ahead - 1)
        school.notes.acknowledge(note)
        school.groups.change(robots.id, {"color": COLORS[-1], "name": "Gatos"})
        school.lessons.close(lesson)
        stores = merged_in_both_orders(tmp_path, school, teacher)
    for store in stores:
        with store:
            assert store.notes.get(note).seen_at is not None
            assert store.lessons.get(lesson).closed_at is not None
            group = store.groups.get(robots.id)
            assert (group.name, group.color) == ("Gatos", COLORS[-1])


JOINS = {
    "a chain": (("A", "B"), ("B", "C"), "C"),
    "a circle": (("A", "B"), ("B", "A"), None),
}


@pytest.mark.parametrize("kind", JOINS)
def test_no_lesson_is_lost_where_two_pcs_have_joined_lessons(
    school: Store, ninth: str, square: ProgramRow, clock: SchoolClock, tmp_path: Path, kind: str
) -> None:
    ids = {title: school.lessons.open(ninth, title).id for title in "ABC"}
    here, there, end = JOINS[kind]
    with open_store(tmp_path / "other.db", clock=clock, uptime=clock.uptime) as other:
        merged(other, exported(school, tmp_path / "b.pinel").path)
        for pc, (part, whole) in ((school, here), (other, there)):
            pc.lessons.change(ids[part], {"part_of": ids[whole]})
        stores = merged_in_both_orders(tmp_path, school, other)
    tree = sorted(ids[title] for title in ("ABC" if end else "AB"))
    root = ids[end] if end else tree[0]
    for store in stores:
        with store:
            shown = {row.id: row.part_of for row in store.lessons.of_classroom(ninth)}
            assert {part for part in shown if shown[part]} == set(tree) - {root}
            assert {shown[part] for part in tree} == {None, root}
            for part in tree:
                assert sorted(store.lessons.parts(part)) == tree
                assert store.lessons.parts(part)[0] == root
            can_be_joined_and_separated(store, tree, root, school.lessons.open(ninth, "D").id)


def can_be_joined_and_separated(store: Store, tree: list[str], root: str, absent: str) -> None:
    lessons = store.lessons
    parts = [part for part in tree if part != root]
    assert code_of(lambda: lessons.change(root, {"part_of": parts[0]})) == "lesson_not_joinable"
    assert code_of(lambda: lessons.change(root, {"part_of": absent})) == "lesson_not_found"
    classroom_id = lessons.get(root).classroom_id
    more = lessons.open(str(classroom_id), "E").id
    assert lessons.change(root, {"part_of": more}).part_of == more
    assert sorted(lessons.parts(parts[0])) == sorted([*tree, more])
    assert lessons.change(root, {"part_of": None}).part_of is None
    assert sorted(lessons.parts(more)) == sorted([more, *parts])
    for part in parts:
        lessons.change(part, {"part_of": None})
    assert all(row.part_of is None for row in lessons.of_classroom(classroom_id))


def test_the_title_of_a_lesson_can_be_taken_away(school: Store, ninth: str) -> None:
    lesson = school.lessons.open(ninth, "Aula 1").id
    for nothing in ("", None):
        assert school.lessons.change(lesson, {"title": nothing}).title == ""
