"""The line that a teacher reads first."""

from pinel_desktop.school.review import GroupReview, Run, review_group, review_lesson, summary
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
    assert (found.fault_run, found.n_with_fault) == ("r2", 3)


def test_a_run_that_was_stopped_by_hand_says_nothing() -> None:
    runs = [
        run("s", "v", 9, 9, state="stopped"),
        *(run(f"t{n}", "v", n, n, **HIT) for n in range(2)),
    ]
    found = summary(review_lesson([group("Tatus", *runs)]), None)
    assert (found.stuck, found.n_passed) == ((), None)


def test_what_only_one_group_did_wrong_is_not_common() -> None:
    review = review_lesson([group("Tatus", *(run(f"t{n}", "v", n, n, **HIT) for n in range(5)))])
    assert summary(review, "square").fault_run is None


def test_an_empty_lesson_has_an_empty_summary() -> None:
    found = summary(review_lesson([]), "square")
    assert (found.n_groups, found.n_passed, found.stuck, found.fault_run) == (0, 0, (), None)
