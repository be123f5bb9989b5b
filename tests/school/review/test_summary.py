"""The summary of a lesson."""

from pinel_desktop.school.review import (
    CommonMistake,
    GroupReview,
    Run,
    review_group,
    review_lesson,
    summary,
)
from tests.school.review.test_lesson import run, work

PASSED = {"activity": "square", "passed": True}
NOT_YET = {"activity": "square", "passed": False}
HIT = {"state": "failed", "reason": "blocked"}


def group(name: str, *runs: Run) -> GroupReview:
    return review_group(work(*runs, name=name), {}, "square")


def test_it_counts_who_passed_and_names_who_is_stuck_in_the_order_of_the_review() -> None:
    review = review_lesson(
        [
            group("Tatus", *(run(f"t{n}", "v", n, n, **NOT_YET) for n in range(3))),
            group("Araras", *(run(f"a{n}", "v", n, n, **HIT) for n in range(3))),
            group(
                "Robos",
                *(run(f"r{n}", "v", n, n, **HIT) for n in range(3)),
                run("r9", "v", 4, 4, **PASSED),
            ),
            group("Gatos", run("g0", "v", 0, 0, **HIT), run("g1", "v", 1, 1, **NOT_YET)),
        ]
    )
    found = summary(review, "square")
    assert (found.n_passed, found.n_groups, found.stuck) == (1, 4, ("Araras", "Tatus"))
    assert found.needs == {
        "id of Araras": "help",
        "id of Gatos": "working",
        "id of Robos": "passed",
        "id of Tatus": "help",
    }
    assert found.mistake == CommonMistake("r2", 3, is_advice=False)


def test_a_run_that_was_stopped_by_hand_says_nothing() -> None:
    runs = [
        run("s", "v", 9, 9, state="stopped"),
        *(run(f"t{n}", "v", n, n, **HIT) for n in range(2)),
    ]
    found = summary(review_lesson([group("Tatus", *runs)]), None)
    assert (found.stuck, found.n_passed) == ((), None)


def test_what_only_one_group_did_wrong_is_not_common() -> None:
    review = review_lesson([group("Tatus", *(run(f"t{n}", "v", n, n, **HIT) for n in range(5)))])
    assert summary(review, "square").mistake is None


def test_what_was_said_about_the_activity_is_named_where_as_many_groups_heard_it() -> None:
    advised = {**NOT_YET, "mistake_key": "square 2"}
    shared = [
        group("Tatus", run("t", "v", 0, 0, **advised), run("t2", "v", 1, 1, **HIT)),
        group("Araras", run("a", "v", 0, 3, **advised), run("a2", "v", 1, 4, **HIT)),
    ]
    assert summary(review_lesson(shared), "square").mistake == CommonMistake("a", 2, is_advice=True)
    more = [*shared, group("Emas", run("e", "v", 0, 9, **HIT))]
    assert summary(review_lesson(more), "square").mistake == CommonMistake("e", 3, is_advice=False)


def test_a_group_that_passed_needs_help_only_with_something_else() -> None:
    passed = run("a", "v", 0, 0, **PASSED)
    same = [run(f"s{n}", "v", n, n, **NOT_YET) for n in range(1, 4)]
    other = [run(f"o{n}", "v", n, n, activity="maze", passed=False) for n in range(1, 4)]
    review = review_lesson([group("Tatus", passed, *same), group("Araras", passed, *other)])
    assert summary(review, "square").needs == {"id of Tatus": "passed", "id of Araras": "help"}


def test_an_empty_lesson_has_an_empty_summary() -> None:
    found = summary(review_lesson([]), "square")
    assert (found.n_groups, found.n_passed, found.stuck, found.mistake) == (0, 0, (), None)
