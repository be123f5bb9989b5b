"""What a teacher reads first of a lesson: how many groups have passed, who is stuck, what went wrong most often."""

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from pinel_desktop.school.review.lesson import LessonReview
from pinel_desktop.school.review.marks import is_failing
from pinel_desktop.school.review.records import Run

_STUCK_AFTER = 3  # failing runs in a row
_SHARED_BY = 2  # groups; what one group alone does wrong is not common


@dataclass(frozen=True, slots=True)
class Summary:
    """The lesson in one line. Groups are in the order of the review, which is no ranking.

    Attributes:
        n_passed: groups that passed the activity; None if the lesson has none.
        stuck: names of the groups whose last runs, three or more, all failed or did not pass.
        fault_run: a run that ended for the commonest reason, the latest one; None if groups share none.
        n_with_fault: groups that had this reason.
    """

    n_groups: int
    n_passed: int | None
    stuck: tuple[str, ...]
    fault_run: str | None
    n_with_fault: int


def summary(review: LessonReview, activity: str | None) -> Summary:
    """The summary of a lesson; `activity` is the lesson's, None without one."""
    groups = {one.id: [mark.run for mark in one.marks if mark.run] for one in review.groups}
    fault_run, n_with_fault = _commonest_fault(groups.values())
    return Summary(
        n_groups=len(review.groups),
        n_passed=sum(_passed(runs, activity) for runs in groups.values()) if activity else None,
        stuck=tuple(one.name for one in review.groups if _is_stuck(groups[one.id])),
        fault_run=fault_run,
        n_with_fault=n_with_fault,
    )


def _passed(runs: Iterable[Run], activity: str | None) -> bool:
    return any(run.passed and run.activity == activity for run in runs)


def _is_stuck(runs: Sequence[Run]) -> bool:
    """A run that was stopped by hand or goes on says nothing."""
    told = [run for run in runs if is_failing(run) or run.state == "finished"]
    last = told[-_STUCK_AFTER:]
    return len(last) == _STUCK_AFTER and all(is_failing(run) for run in last)


def _commonest_fault(groups: Iterable[Sequence[Run]]) -> tuple[str | None, int]:
    """The latest run with the reason that most groups had, and how many had it."""
    latest: dict[str, Run] = {}
    n_groups: Counter[str] = Counter()
    for runs in groups:
        failed = [run for run in runs if run.state == "failed" and run.reason]
        n_groups.update({run.reason or "" for run in failed})
        for run in failed:
            reason = run.reason or ""
            latest[reason] = max(run, latest.get(reason, run), key=lambda one: one.at)
    if not n_groups:
        return None, 0
    reason = max(sorted(n_groups), key=lambda one: n_groups[one])
    n = n_groups[reason]
    return (latest[reason].id, n) if n >= _SHARED_BY else (None, 0)
