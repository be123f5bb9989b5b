"""The review of a lesson: order of entries, and metrics."""

from typing import Any

from pinel_desktop.school.review import (
    BlocksInUse,
    Counts,
    Edit,
    GroupReview,
    GroupWork,
    Run,
    review_group,
    review_lesson,
    versions_needed,
)
from pinel_desktop.school.review.lesson_events import key_of
from pinel_desktop.school.review.order import timelines_of
from tests.school.review.sketches import move, start, workspace_of


def at(minute: float) -> str:
    return f"2026-03-02T08:{int(minute):02}:{round(minute % 1 * 60):02}.000000Z"


def edit(key: str, number: int, minute: float = 0, **more: Any) -> Edit:
    more = {"computer_id": "pc", "program_id": "p", **more}
    return Edit(version_id=key, program_name="Quadrado", number=number, at=at(minute), **more)


def run(key: str, version: str, number: int, minute: float = 0, **more: Any) -> Run:
    more = {"computer_id": "pc", "program_id": "p", "state": "finished", "duration_s": 6.0, **more}
    return Run(
        key,
        program_name="Quadrado",
        version_id=version,
        number=number,
        at=at(minute),
        ended_at=at(minute + 0.1),
        **more,
    )


def work(*events: Edit | Run, name: str = "Os Robôs") -> GroupWork:
    edits = tuple(event for event in events if isinstance(event, Edit))
    runs = tuple(event for event in events if isinstance(event, Run))
    return GroupWork(f"id of {name}", name, edits, runs)


def workspaces(**metres: float) -> dict[str, object]:
    """Returns workspaces of versions with one block each, by version id."""
    return {key: workspace_of([start(), move(metres=amount)]) for key, amount in metres.items()}


def review(*events: Edit | Run, activity: str | None = None, **metres: float) -> GroupReview:
    return review_group(work(*events), workspaces(**metres), activity)


def keys(*events: Edit | Run) -> list[str]:
    return [key_of(event) for line in timelines_of(work(*events)) for event in line]


def test_bursts_between_runs_are_one_mark_with_what_changed() -> None:
    found = review(
        edit("a", 1, 0),
        edit("b", 2, 1),
        run("c", "b", 2, 2),
        edit("d", 3, 3),
        edit("e", 4, 4),
        a=1,
        b=1,
        d=2,
        e=1,
    )
    assert [(mark.kind, mark.n_edits, mark.version_id) for mark in found.timeline] == [
        ("edit", 2, "b"),
        ("run", 0, "b"),
        ("edit", 2, "e"),
    ]
    first, _, last = found.timeline
    assert (first.at, first.until) == (at(0), at(1))
    assert first.changes == Counts(added=1)
    # a change that was undone between two runs does not count
    assert (last.since, last.changes) == ("b", Counts())


def test_edits_of_two_programs_are_two_marks() -> None:
    found = review(edit("a", 1), edit("b", 1, program_id="q"), edit("c", 2), a=1, b=1, c=2)
    assert [mark.program_id for mark in found.timeline] == ["p", "q", "p"]
    assert [mark.changes for mark in found.timeline] == [
        Counts(added=1),
        Counts(added=1),
        Counts(changed=1),
    ]
    assert found.blocks == BlocksInUse({"move_forward": 2}, {})


def test_a_burst_ends_at_a_long_pause() -> None:
    found = review(edit("a", 1, 0), edit("b", 2, 5), edit("c", 3, 11), a=1, b=1, c=2)
    assert [(mark.at, mark.until, mark.n_edits) for mark in found.timeline] == [
        (at(0), at(5), 2),
        (at(11), at(11), 1),
    ]
    assert (found.timeline[1].since, found.timeline[1].changes) == ("b", Counts(changed=1))


def test_a_version_that_changed_its_setup_only_is_no_change_of_blocks() -> None:
    found = review(
        edit("a", 1, 0, setup_only=True, parent_id="old"),
        edit("b", 2, 1),
        edit("c", 3, 2),
        edit("d", 4, 3, setup_only=True, n_hints=1),
        run("e", "d", 4, 4),
        edit("f", 5, 5, setup_only=True, n_hints=2),
        run("g", "f", 5, 6),
        old=1,
        a=1,
        c=2,
        d=2,
        f=2,
    )
    assert [(mark.kind, mark.n_edits, mark.version_id) for mark in found.timeline] == [
        ("edit", 2, "d"),
        ("run", 0, "d"),
        ("run", 0, "f"),
    ]
    burst = found.timeline[0]
    assert (burst.at, burst.until) == (at(1), at(2))
    assert (burst.since, burst.changes) == ("old", Counts(changed=1))
    figures = found.metrics
    assert (figures.n_edits, figures.n_runs, figures.n_hints) == (2, 2, 2)
    assert figures.time_to_first_run_s == 180.0
    assert figures.active_s == 366.0


def test_a_program_whose_setup_alone_was_changed_has_its_blocks_but_no_mark() -> None:
    event = edit("b", 7, parent_id="a", setup_only=True)
    found = review(event, b=1)
    assert (found.timeline, found.metrics.n_edits) == ((), 0)
    assert found.blocks == BlocksInUse({"move_forward": 1}, {})
    assert versions_needed(work(event)) == {"b"}


def test_only_the_workspaces_between_marks_are_asked_for() -> None:
    edits = [edit(f"v{number:03}", number, number / 10, parent_id="old") for number in range(5, 99)]
    group = work(*edits, run("x", "v098", 98, 20))
    assert versions_needed(group) == {"old", "v098"}
    assert versions_needed(work()) == frozenset()


def test_changes_are_unknown_where_a_version_is_not_at_hand() -> None:
    found = review(edit("b", 7, parent_id="elsewhere"), b=1)
    assert (found.timeline[0].since, found.timeline[0].changes) == ("elsewhere", None)
    assert review(edit("b", 7), b=1).timeline[0].changes is None


def test_the_first_good_run_after_a_failing_one_is_its_repair() -> None:
    found = review(
        edit("a", 1),
        run("b", "a", 1, state="failed", reason="collision"),
        run("c", "a", 1, state="stopped"),
        run("d", "a", 1, state="failed", reason="collision"),
        edit("e", 2),
        run("f", "e", 2),
        run("g", "e", 2),
        a=1,
        e=0.5,
    )
    repairs = {mark.run.id: mark.repairs for mark in found.timeline if mark.run}
    assert repairs == {"b": None, "c": None, "d": None, "f": "d", "g": None}
    (repair,) = [mark for mark in found.timeline if mark.repairs]
    assert (repair.since, repair.changes) == ("a", Counts(changed=1))
    assert found.metrics.n_failed == 2


def test_what_did_not_pass_is_repaired_by_passing() -> None:
    square: dict[str, Any] = {"activity": "square"}
    found = review(
        edit("a", 1),
        run("b", "a", 1, passed=False, **square),
        run("c", "a", 1),
        run("d", "a", 1, passed=True, activity="other"),
        run("e", "a", 1, passed=True, **square),
        a=1,
    )
    assert [mark.repairs for mark in found.timeline if mark.run] == [None, None, None, "b"]
    assert found.metrics.n_failed == 0


def test_a_run_of_another_program_repairs_nothing() -> None:
    found = review(run("b", "a", 1, state="failed"), run("c", "x", 1, program_id="q"))
    assert [mark.repairs for mark in found.timeline] == [None, None]


def test_attempts_count_runs_of_the_activity_up_to_the_first_that_passed() -> None:
    runs = [
        run("a", "v", 1, activity="square", passed=False),
        run("b", "v", 1),
        run("c", "v", 1, activity="maze", passed=True),
        run("d", "v", 1, activity="square", state="stopped", passed=False),
        run("e", "v", 1, activity="square", passed=True),
        run("f", "v", 1, activity="square", passed=True),
    ]
    assert review(*runs, activity="square").metrics.attempts_until_passed == 3
    assert review(*runs).metrics.attempts_until_passed == 1
    assert review(*runs[:2], activity="square").metrics.attempts_until_passed is None
    assert review(*runs).metrics.n_runs == 6


def test_time_to_the_first_run_counts_from_the_first_edit() -> None:
    first, second = edit("a", 1, 1), edit("b", 2, 2)
    assert review(first, second, run("c", "b", 2, 3.5)).metrics.time_to_first_run_s == 150
    assert review(first).metrics.time_to_first_run_s is None
    assert review(run("0", "z", 1, 0), first).metrics.time_to_first_run_s is None
    on_other_pc = run("c", "b", 2, 3, computer_id="other")
    assert review(first, on_other_pc).metrics.time_to_first_run_s is None


def test_hours_in_which_nobody_was_there_do_not_count_before_the_first_run() -> None:
    lessons_of_two_days = (
        edit("a", 1, 1),
        edit("b", 2, 20),
        Edit("c", "p", "", 3, at="2026-03-04T09:00:00Z", computer_id="pc"),
        Run("d", "p", "", "c", "2026-03-04T09:01:30Z", "finished", 3, computer_id="pc"),
    )
    assert review(*lessons_of_two_days).metrics.time_to_first_run_s == 19 * 60 + 90


def test_active_time_leaves_long_pauses_out() -> None:
    events: list[Edit | Run] = [
        edit("a", 1, 0),
        edit("b", 2, 4),
        edit("c", 3, 20),
        run("d", "c", 3, 22),
    ]
    assert review(*events).metrics.active_s == 4 * 60 + 2 * 60 + 6
    assert review(edit("a", 1, 10), edit("b", 2, 5)).metrics.active_s == 0
    paused = Run("r", "p", "", "a", at(0), "finished", ended_at=at(40), duration_s=30)
    assert review(paused).metrics.active_s == 30
    running = Run("r", "p", "", "a", at(0), "running")
    assert review(running).metrics.active_s == 0


def test_a_clock_that_is_set_back_does_not_turn_the_order_round() -> None:
    events: list[Edit | Run] = [
        edit("m1", 1),
        edit("m2", 2),
        run("m3", "m2", 2),
        # the app was started again, with a clock that shows last year
        edit("a1", 3),
        run("a2", "a1", 3),
        edit("a3", 4),
    ]
    assert keys(*events) == keys(*reversed(events)) == ["m1", "m2", "m3", "a1", "a2", "a3"]


def test_an_old_version_that_is_run_again_stands_where_it_was_run() -> None:
    events: list[Edit | Run] = [
        edit("a", 1),
        run("b", "a", 1),
        edit("c", 2),
        run("d", "a", 1),
        edit("e", 3),
    ]
    assert keys(*reversed(events)) == ["a", "b", "c", "d", "e"]


def test_work_at_a_second_pc_comes_after_the_work_that_it_went_on_from() -> None:
    there: dict[str, Any] = {"computer_id": "other"}
    events: list[Edit | Run] = [
        edit("a1", 3, parent_id="m2", **there),
        run("a2", "a1", 3, **there),
        edit("m1", 1),
        edit("m2", 2),
    ]
    assert keys(*events) == ["m1", "m2", "a1", "a2"]
    turns: list[Edit | Run] = [edit("b", 2, parent_id="a", **there), edit("a", 1, parent_id="b")]
    assert keys(*turns) == ["a", "b"]


def test_a_repair_may_be_made_at_another_pc() -> None:
    found = review(
        edit("m1", 1),
        run("m2", "m1", 1, state="failed"),
        edit("a1", 2, parent_id="m1", computer_id="other"),
        run("a2", "a1", 2, computer_id="other"),
        m1=1,
        a1=2,
    )
    assert [mark.repairs for mark in found.timeline] == [None, None, None, "m2"]
    assert [mark.changes for mark in found.timeline][2:] == [Counts(changed=1), Counts(changed=1)]


def test_groups_are_ordered_by_name_and_by_nothing_else() -> None:
    names = ["zebra", "Águia", "abelha", "Grupo 10", "Grupo 2"]
    groups = [review_group(work(name=name), {}) for name in names]
    ordered = [group.name for group in review_lesson(groups).groups]
    assert ordered == ["abelha", "Águia", "Grupo 2", "Grupo 10", "zebra"]
    assert ordered == [group.name for group in review_lesson(reversed(groups)).groups]
