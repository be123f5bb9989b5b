"""Summary of a lesson for the teacher: how many groups have passed, who is stuck, and the commonest mistake."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from pinel_desktop.school.review.group_timeline import is_failing
from pinel_desktop.school.review.lesson import LessonReview
from pinel_desktop.school.review.lesson_events import Run
from pinel_desktop.school.review.status import GroupStatus, status_of

Need = Literal["help", "working", "passed"]

_STUCK_AFTER = 3  # failing runs in a row
_SHARED_BY = 2  # groups; a mistake of one group alone is not common


@dataclass(frozen=True, slots=True)
class CommonMistake:
    """The commonest mistake of a lesson; at least two groups made it.

    Attributes:
        run: id of the latest run with the mistake.
        is_advice: True if the mistake is the diagnosis or check text of the activity; False if it is the reason why the
            run failed.
    """

    run: str
    n_groups: int
    is_advice: bool


@dataclass(frozen=True, slots=True)
class Summary:
    """The lesson in one line. Groups are in the order of the review, which is no ranking.

    The page shows the groups by need: first those that need help, then those at work, then those that have passed; of
    equal need in the order of the review.

    Attributes:
        n_passed: groups that passed the activity; None if the lesson has none.
        stuck: names of the groups whose last three runs all failed or did not pass.
        needs: by the group's id: "help" if the group is stuck, "passed" if it passed the activity, else "working".
        statuses: by the group's id: what it is at.
        mistake: None if no mistake is common to two groups.
    """

    n_groups: int
    n_passed: int | None
    stuck: tuple[str, ...]
    needs: Mapping[str, Need]
    statuses: Mapping[str, GroupStatus]
    mistake: CommonMistake | None


def summary(review: LessonReview, activity: str | None) -> Summary:
    """Returns the summary of a lesson; `activity` is the lesson's, None without one."""
    groups = {one.id: [entry.run for entry in one.timeline if entry.run] for one in review.groups}
    needs = {key: _need(runs, activity) for key, runs in groups.items()}
    return Summary(
        n_groups=len(review.groups),
        n_passed=sum(_passed(runs, activity) for runs in groups.values()) if activity else None,
        stuck=tuple(one.name for one in review.groups if needs[one.id] == "help"),
        needs=needs,
        statuses={
            one.id: status_of(
                groups[one.id],
                has_passed=needs[one.id] == "passed",
                attempts=one.metrics.attempts_until_passed,
            )
            for one in review.groups
        },
        mistake=_commonest_mistake(groups.values()),
    )


def _passed(runs: Iterable[Run], activity: str | None) -> bool:
    return any(run.passed and run.activity == activity for run in runs)


def _need(runs: Sequence[Run], activity: str | None) -> Need:
    """Returns the need of a group. If it has passed and its failing runs are of the same activity, it needs no help."""
    has_passed = activity is not None and _passed(runs, activity)
    last = _last_failing(runs)
    tries_on = has_passed and any(run.activity == activity for run in last)
    if len(last) == _STUCK_AFTER and not tries_on:
        return "help"
    return "passed" if has_passed else "working"


def _last_failing(runs: Sequence[Run]) -> list[Run]:
    """Returns the failing runs among the last three conclusive runs: runs that ended and were not stopped by hand."""
    conclusive = [
        run for run in runs if is_failing(run) or (run.state == "finished" and _is_conclusive(run))
    ]
    return [run for run in conclusive[-_STUCK_AFTER:] if is_failing(run)]


def _is_conclusive(run: Run) -> bool:
    """False for a real run of an activity that was not judged; it neither failed nor ends a series of failures."""
    return run.activity is None or run.counts


def _commonest_mistake(groups: Iterable[Sequence[Run]]) -> CommonMistake | None:
    """Returns the commonest mistake. At equal numbers of groups, advice precedes the reason: it is more precise."""
    latest: dict[tuple[bool, str], Run] = {}
    n_groups: Counter[tuple[bool, str]] = Counter()
    for runs in groups:
        found = [(fault, run) for run in runs for fault in _faults(run)]
        n_groups.update({fault for fault, _ in found})
        for fault, run in found:
            latest[fault] = max(run, latest.get(fault, run), key=lambda one: one.at)
    if not n_groups:
        return None
    fault = max(sorted(n_groups), key=lambda one: (n_groups[one], one[0]))
    n = n_groups[fault]
    return CommonMistake(latest[fault].id, n, is_advice=fault[0]) if n >= _SHARED_BY else None


def _faults(run: Run) -> Iterator[tuple[bool, str]]:
    if run.mistake_key and is_failing(run):
        yield True, run.mistake_key
    if run.state == "failed" and run.reason:
        yield False, run.reason
