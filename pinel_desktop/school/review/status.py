"""What a group of a lesson is at, as facts: the newest run that says something, or its pass of the activity."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import takewhile
from typing import Literal

from pinel_desktop.school.review.group_timeline import is_failing
from pinel_desktop.school.review.lesson_events import Run

StatusKind = Literal[
    "not_run", "running", "stopped", "finished", "collision", "failed", "not_passed", "passed"
]

_COLLISIONS = ("blocked", "blocked_beside")


@dataclass(frozen=True, slots=True)
class GroupStatus:
    """What a group is at.

    Attributes:
        n: of a failing run, how many runs in a row failed in the same way; of "passed", the attempts until then, 0 if
            they are unknown.
        run: the run that it is about; None for "not_run", and for a pass of the lesson's activity.
    """

    kind: StatusKind
    n: int = 0
    run: Run | None = None


def status_of(runs: Sequence[Run], *, has_passed: bool, attempts: int | None) -> GroupStatus:
    """Returns the status of a group from its runs in order.

    Args:
        has_passed: the group has passed the lesson's activity and needs no help.
        attempts: until then.
    """
    if has_passed:
        return GroupStatus("passed", attempts or 0)
    if not runs:
        return GroupStatus("not_run")
    last = runs[-1]
    if last.state == "running":
        return GroupStatus("running", run=last)
    said = [run for run in runs if run.state != "stopped" or is_failing(run) or run.passed]
    if not said:
        return GroupStatus("stopped", len(runs), last)
    last = said[-1]
    n = len(list(takewhile(lambda run: _fault(run) == _fault(last), reversed(said))))
    return GroupStatus(_kind(last), n if is_failing(last) else 0, last)


def _kind(run: Run) -> StatusKind:
    if run.state == "failed":
        return "collision" if run.reason in _COLLISIONS else "failed"
    if run.passed is None:
        return "finished"
    return "passed" if run.passed else "not_passed"


def _fault(run: Run) -> tuple[object, ...]:
    """Equal for runs that failed in the same way: a collision counts by its block, any other failure by its cause."""
    cause = run.block if run.reason in _COLLISIONS else run.mistake_key
    return run.activity, is_failing(run), run.state, run.reason, cause
