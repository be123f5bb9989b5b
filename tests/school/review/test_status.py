"""What a group is at: the facts of the one sentence in the review of a lesson."""

import pytest

from pinel_desktop.school.review import GroupStatus, Run, status_of
from tests.school.review.test_lesson import run

NOT_YET = {"activity": "square", "passed": False}


def hit(n: int, block: str = "b") -> Run:
    return run(f"h{n}", "v", n, n, state="failed", reason="blocked", block=block)


def status(*runs: Run) -> tuple[str, int, str | None]:
    found = status_of(runs, has_passed=False, attempts=None)
    return found.kind, found.n, found.run.id if found.run else None


def test_collisions_in_a_row_are_counted_by_their_block() -> None:
    assert status(hit(1, "a"), hit(2), hit(3)) == ("collision", 2, "h3")


def test_a_finished_run_resets_the_count() -> None:
    assert status(hit(1), run("f", "v", 2, 2), hit(3)) == ("collision", 1, "h3")


def test_runs_that_were_stopped_by_hand_say_nothing_unless_there_is_no_other() -> None:
    stopped = run("s", "v", 3, 3, state="stopped")
    assert status(hit(1), stopped) == ("collision", 1, "h1")
    assert status(stopped, stopped) == ("stopped", 2, "s")


def test_what_the_activity_said_is_counted_while_it_stays_the_same() -> None:
    def missed(n: int, key: str) -> Run:
        return run(f"m{n}", "v", n, n, mistake_key=key, **NOT_YET)

    assert status(missed(1, "side"), missed(2, "turn"), missed(3, "turn")) == (
        "not_passed",
        2,
        "m3",
    )


@pytest.mark.parametrize(
    ("runs", "kind"),
    [
        ([], "not_run"),
        ([run("r", "v", 1, 1, state="running")], "running"),
        ([run("f", "v", 1, 1)], "finished"),
        ([run("p", "v", 1, 1, activity="maze", passed=True)], "passed"),
        ([run("i", "v", 1, 1, state="failed", reason="interrupted")], "failed"),
    ],
)
def test_every_group_is_at_something(runs: list[Run], kind: str) -> None:
    assert status(*runs)[0] == kind


def test_a_pass_of_the_activity_outweighs_what_came_later() -> None:
    found = status_of([hit(1)], has_passed=True, attempts=2)
    assert found == GroupStatus("passed", 2)
