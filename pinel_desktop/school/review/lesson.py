"""Review of a lesson: timeline and metrics of each group. Nothing here compares groups.

For people, `figure_NAME` in `messages/catalogue/LANGUAGE/review.json` explains each metric.
"""

import re
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from itertools import pairwise
from unicodedata import combining, normalize

from pinel_desktop.school.review.blocks import BlocksInUse, FlatWorkspace, blocks_in_flat, flatten
from pinel_desktop.school.review.clock import AWAY_S, PAUSE_S, seconds_of
from pinel_desktop.school.review.group_timeline import (
    NOTHING,
    TimelineEntry,
    timeline_of,
    with_changes,
)
from pinel_desktop.school.review.lesson_events import Edit, Event, GroupWork, Run
from pinel_desktop.school.review.order import timelines_of


@dataclass(frozen=True, slots=True)
class GroupMetrics:
    """Metrics of a group in one lesson.

    Attributes:
        n_edits: saved versions whose blocks changed.
        n_runs: runs started, including stopped ones.
        n_failed: runs that ended with an error; a stop by hand or a failed activity is not an error.
        time_to_first_run_s: from the first edit to the first run after it, by the clock of the PC, without absences of
            more than an hour; None without a run, if the lesson started with a run, or if the clocks of two PCs are
            involved.
        attempts_until_passed: ended runs of the activity that count, up to and including the first that passed; None if
            none passed. The activity is the lesson's, else the activity of the first run that passed.
        n_hints: hints of activities that were opened, of all programs of the lesson.
        active_s: time with runs and saved versions of any kind, without pauses of more than five minutes.
    """

    n_edits: int
    n_runs: int
    n_failed: int
    time_to_first_run_s: float | None
    attempts_until_passed: int | None
    n_hints: int
    active_s: float


@dataclass(frozen=True, slots=True)
class GroupReview:
    """A group's timeline, its metrics, and the blocks of its programs at the end of the lesson.

    Attributes:
        hints: by activity, how many of its hints were opened; hints open one after the other.
    """

    id: str
    name: str
    timeline: tuple[TimelineEntry, ...]
    metrics: GroupMetrics
    blocks: BlocksInUse
    hints: Mapping[str, int]


@dataclass(frozen=True, slots=True)
class LessonReview:
    """All groups that worked in the lesson, ordered by name."""

    groups: tuple[GroupReview, ...]


def versions_needed(work: GroupWork) -> frozenset[str]:
    """Ids of the versions whose workspaces `review_group` needs: before and after each burst, and the last ones."""
    entries = timeline_of(work)
    differing = (entry for entry in entries if entry.is_shown and entry.since is not None)
    compared = {key for entry in differing for key in _compared(entry)}
    return frozenset(compared.union(_last_versions(entries)) - {NOTHING})


def review_group(
    work: GroupWork, workspaces: Mapping[str, object], activity: str | None = None
) -> GroupReview:
    """Returns the review of one group.

    Args:
        workspaces: by version id, for `versions_needed`; changes of missing ones are unknown (None).
        activity: the activity of the lesson, None without one.
    """
    flat = {NOTHING: FlatWorkspace(), **{key: flatten(one) for key, one in workspaces.items()}}
    all_entries = timeline_of(work)
    uses = [blocks_in_flat(flat[key]) for key in _last_versions(all_entries) if key in flat]
    entries = tuple(with_changes(entry, flat) for entry in all_entries if entry.is_shown)
    figures, blocks = _metrics(work, entries, activity), _sum(uses)
    return GroupReview(work.id, work.name, entries, figures, blocks, _opened_hints(work.edits))


def review_lesson(groups: Iterable[GroupReview]) -> LessonReview:
    """Orders the groups by name; any other order would be a ranking."""
    return LessonReview(tuple(sorted(groups, key=lambda group: (_by_name(group.name), group.id))))


def _by_name(name: str) -> list[tuple[int, str]]:
    """Sort key that ignores accents and case and puts 2 before 10."""
    letters = (char for char in normalize("NFKD", name) if not combining(char))
    parts = re.split(r"([0-9]+)", "".join(letters).casefold())
    return [(int(part) if re.fullmatch("[0-9]{1,18}", part) else 0, part) for part in parts]


def _compared(entry: TimelineEntry) -> tuple[str, str]:
    return entry.since or NOTHING, entry.version_id or NOTHING


def _last_versions(entries: Iterable[TimelineEntry]) -> list[str]:
    """Id of the last version of each program."""
    return list(
        {entry.program_id: entry.version_id for entry in entries if entry.version_id}.values()
    )


def _sum(uses: Iterable[BlocksInUse]) -> BlocksInUse:
    attached: Counter[str] = Counter()
    loose: Counter[str] = Counter()
    for use in uses:
        attached.update(use.attached)
        loose.update(use.loose)
    return BlocksInUse(dict(sorted(attached.items())), dict(sorted(loose.items())))


def _metrics(
    work: GroupWork, entries: tuple[TimelineEntry, ...], activity: str | None
) -> GroupMetrics:
    runs = [entry.run for entry in entries if entry.run]
    return GroupMetrics(
        n_edits=sum(entry.n_edits for entry in entries),
        n_runs=len(runs),
        n_failed=sum(run.state == "failed" for run in runs),
        time_to_first_run_s=_time_to_first_run(entries),
        attempts_until_passed=_attempts(runs, activity),
        n_hints=_hints(work.edits),
        active_s=sum(map(_active, timelines_of(work))),
    )


def _time_to_first_run(entries: tuple[TimelineEntry, ...]) -> float | None:
    first_run = next((entry for entry in entries if entry.run), None)
    if first_run is None or first_run is entries[0]:
        return None
    before = entries[: entries.index(first_run)]
    time_s = seconds_of(first_run.at) - seconds_of(entries[0].at)
    same_clock = first_run.computer_id == entries[0].computer_id
    return time_s - _away(before, first_run) if same_clock and time_s >= 0.0 else None


def _away(before: tuple[TimelineEntry, ...], first_run: TimelineEntry) -> float:
    """Seconds in which the group was absent: joined lessons may be days apart."""
    pauses = (
        seconds_of(after.at) - seconds_of(entry.until or entry.at)
        for entry, after in pairwise((*before, first_run))
        if entry.computer_id == after.computer_id == first_run.computer_id
    )
    return sum(pause for pause in pauses if pause > AWAY_S)


def _attempts(runs: list[Run], activity: str | None) -> int | None:
    passed = (run for run in runs if run.passed and activity in (None, run.activity))
    first = next(passed, None)
    if first is None:
        return None
    tries = runs[: runs.index(first) + 1]
    return sum(
        run.activity == first.activity and run.state != "running" and run.counts for run in tries
    )


def _hints(edits: Iterable[Edit]) -> int:
    opened: Counter[str] = Counter()
    for edit in edits:
        opened[edit.program_id] = max(opened[edit.program_id], edit.n_hints)
    return opened.total()


def _opened_hints(edits: Iterable[Edit]) -> dict[str, int]:
    opened: dict[str, int] = {}
    for edit in edits:
        if edit.activity and edit.n_hints:
            opened[edit.activity] = max(opened.get(edit.activity, 0), edit.n_hints)
    return opened


def _active(line: Iterable[Event]) -> float:
    """Seconds of activity on one PC, including short pauses."""
    active_s = 0.0
    last = reached = None
    for event in line:
        begin, end = _span(event)
        if last is None or reached is None or begin < last or begin - reached > PAUSE_S:
            reached = begin  # first event, clock set back, or long pause
        active_s += max(0.0, end - reached)
        last, reached = begin, max(reached, end)
    return active_s


def _span(event: Event) -> tuple[float, float]:
    """Start and end of an event in s.

    A run counts by the PC's clock. If that exceeds robot time by more than five minutes, such as in a forgotten pause,
    the run counts by robot time.
    """
    begin = seconds_of(event.at)
    if isinstance(event, Edit):
        return begin, begin
    took_s = event.duration_s or 0.0
    waited_s = seconds_of(event.ended_at) - begin if event.ended_at else took_s
    return begin, begin + (waited_s if 0.0 <= waited_s <= took_s + PAUSE_S else took_s)
