"""Timeline of a group: bursts of edits, which end at a run or a long pause, and runs, with repairs of failed runs."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace

from pinel_desktop.school.review.blocks import FlatWorkspace
from pinel_desktop.school.review.clock import PAUSE_S, seconds_of
from pinel_desktop.school.review.difference import Counts, difference_of_flat
from pinel_desktop.school.review.lesson_events import Edit, Event, GroupWork, Run
from pinel_desktop.school.review.order import timelines_of

# used in place of a version id: the empty program, with which a burst may start
NOTHING = ""


@dataclass(frozen=True, slots=True)
class TimelineEntry:
    """An entry on the timeline: a burst of edits, or a run.

    Attributes:
        version_id: the last version saved in a burst, or the version that ran.
        at, until: start and end by the clock of the PC. For a burst, its first and last change of blocks; `until` is
            None while a run is live.
        number: number of that version in its program.
        n_edits: number of versions in the burst that changed blocks; 0 for a run, and for a burst that is not shown.
        run: None for edits.
        since: the version with which `changes` compares: the version before the burst, or of the run that is repaired;
            "" for the empty program, None if unknown.
        changes: difference from `since` to `version_id`, without changes undone in between. None for a run that repairs
            nothing, and if a version is missing.
        repairs: id of the failed run that this run repairs.
    """

    at: str
    until: str | None
    program_id: str | None
    program_name: str | None
    version_id: str | None
    computer_id: str | None
    lesson_id: str | None = None
    number: int | None = None
    n_edits: int = 0
    run: Run | None = None
    since: str | None = None
    changes: Counts | None = None
    repairs: str | None = None

    @property
    def kind(self) -> str:
        """ "edit" or "run"."""
        return "run" if self.run else "edit"

    @property
    def is_shown(self) -> bool:
        """False for a burst in which only world, start, robot, speed or hints changed."""
        return self.run is not None or self.n_edits > 0


def timeline_of(work: GroupWork) -> tuple[TimelineEntry, ...]:
    """Returns the entries in chronological order, without `changes`; includes bursts without a change of blocks."""
    entries: list[TimelineEntry] = []
    latest: dict[str, str] = {}  # program -> its latest version so far
    for line in timelines_of(work):
        entries.extend(_entries_of(line, latest))
    return tuple(_with_repairs(entries))


def with_changes(entry: TimelineEntry, known: Mapping[str, FlatWorkspace]) -> TimelineEntry:
    """Returns the entry with its `changes` if both versions are in `known`, which must contain `NOTHING`."""
    if (
        entry.since is None
        or entry.version_id is None
        or not {entry.since, entry.version_id} <= known.keys()
    ):
        return entry
    changes = difference_of_flat(known[entry.since], known[entry.version_id]).summary
    return replace(entry, changes=changes)


def is_failing(run: Run) -> bool:
    """True if the run ended with an error or did not pass the activity."""
    return run.state == "failed" or run.passed is False


def is_repair(run: Run, failing: Run) -> bool:
    """True if the run passed and the failing one did not pass, or if it finished and the failing one did not finish."""
    if failing.passed is False:
        return run.passed is True and run.activity == failing.activity
    return run.passed is True or (run.state == "finished" and run.passed is None)


def _entries_of(line: Iterable[Event], latest: dict[str, str]) -> Iterator[TimelineEntry]:
    burst: list[Edit] = []
    for event in line:
        if burst and _ends(burst, event):
            yield _burst(burst, latest)
            burst = []
        if isinstance(event, Edit):
            burst.append(event)
        else:
            yield _run(event)
            if event.program_id and event.version_id:
                latest.setdefault(event.program_id, event.version_id)
    if burst:
        yield _burst(burst, latest)


def _ends(burst: list[Edit], event: Event) -> bool:
    if isinstance(event, Run) or event.program_id != burst[0].program_id:
        return True
    return seconds_of(event.at) - seconds_of(burst[-1].at) > PAUSE_S


def _burst(edits: list[Edit], latest: dict[str, str]) -> TimelineEntry:
    first, last = edits[0], edits[-1]
    start_version = NOTHING if first.number == 1 else None
    since = latest.get(first.program_id) or first.parent_id or start_version
    latest[last.program_id] = last.version_id
    of_blocks = [edit for edit in edits if not edit.setup_only]
    shown = of_blocks or edits
    entry = _entry(last, shown[0].at, shown[-1].at)
    return replace(entry, n_edits=len(of_blocks), since=since)


def _run(run: Run) -> TimelineEntry:
    return replace(_entry(run, run.at, run.ended_at), run=run)


def _entry(of: Edit | Run, at: str, until: str | None) -> TimelineEntry:
    return TimelineEntry(
        at=at,
        until=until,
        program_id=of.program_id,
        program_name=of.program_name,
        version_id=of.version_id,
        computer_id=of.computer_id,
        lesson_id=of.lesson_id,
        number=of.number,
    )


def _with_repairs(entries: Iterable[TimelineEntry]) -> Iterator[TimelineEntry]:
    """Sets `repairs` on the first good run of a program after a failed one, to the last failed run before it."""
    failing: dict[str, Run] = {}
    for entry in entries:
        run, program = entry.run, entry.program_id or ""
        if run is None:
            yield entry
        elif is_failing(run):
            failing[program] = run
            yield entry
        elif program in failing and is_repair(run, failing[program]):
            repaired = failing.pop(program)
            yield replace(entry, repairs=repaired.id, since=repaired.version_id)
        else:
            yield entry
