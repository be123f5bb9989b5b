"""A group's line of marks: bursts of edits, which end at a run or a long pause, runs, and which run repaired which."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace

from pinel_desktop.school.review.blocks import Sheet
from pinel_desktop.school.review.clock import PAUSE_S, seconds_of
from pinel_desktop.school.review.difference import Counts, difference_of_sheets
from pinel_desktop.school.review.order import lines_of
from pinel_desktop.school.review.records import Edit, Event, GroupWork, Run

# in place of a version: the program began with this burst
NOTHING = ""


@dataclass(frozen=True, slots=True)
class Mark:
    """One mark on the line.

    Attributes:
        version_id: of edits the last one saved, of a run what ran.
        at, until: its beginning and end by the clock of that PC; `until` None while a run goes on.
        number: of that version in its program.
        n_edits: how many versions were saved in the burst; 0 for a run.
        run: None for edits.
        since: the version that `changes` counts from: the one before the burst, or the one whose run is repaired;
            "" for the empty program, None where nobody knows.
        changes: what differs between `since` and `version_id`; what was put there and taken away again in between
            does not count. None for a run that repairs nothing, and where a version is not at hand.
        repairs: id of the failing run that this one made good.
    """

    at: str
    until: str | None
    program_id: str | None
    program_name: str | None
    version_id: str | None
    computer_id: str | None
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


def marks_of(work: GroupWork) -> tuple[Mark, ...]:
    """The marks in the order in which they happened, without `changes`."""
    marks: list[Mark] = []
    seen: dict[str, str] = {}  # program -> the version that it was last seen in
    for line in lines_of(work):
        marks.extend(_marks_of_line(line, seen))
    return tuple(_with_repairs(marks))


def with_changes(mark: Mark, known: Mapping[str, Sheet]) -> Mark:
    """The mark with what changed, where both versions are known; `NOTHING` is to be among them."""
    if (
        mark.since is None
        or mark.version_id is None
        or not {mark.since, mark.version_id} <= known.keys()
    ):
        return mark
    changes = difference_of_sheets(known[mark.since], known[mark.version_id]).summary
    return replace(mark, changes=changes)


def is_failing(run: Run) -> bool:
    """Whether it broke off with an error, or ended without passing the activity."""
    return run.state == "failed" or run.passed is False


def is_repair(run: Run, failing: Run) -> bool:
    """Whether it did what the failing one did not: pass where that did not pass, else come to its end."""
    if failing.passed is False:
        return run.passed is True and run.activity == failing.activity
    return run.passed is True or (run.state == "finished" and run.passed is None)


def _marks_of_line(line: Iterable[Event], seen: dict[str, str]) -> Iterator[Mark]:
    burst: list[Edit] = []
    for event in line:
        if burst and _ends(burst, event):
            yield _burst(burst, seen)
            burst = []
        if isinstance(event, Edit):
            burst.append(event)
        else:
            yield _run(event)
            if event.program_id and event.version_id:
                seen.setdefault(event.program_id, event.version_id)
    if burst:
        yield _burst(burst, seen)


def _ends(burst: list[Edit], event: Event) -> bool:
    if isinstance(event, Run) or event.program_id != burst[0].program_id:
        return True
    return seconds_of(event.at) - seconds_of(burst[-1].at) > PAUSE_S


def _burst(edits: list[Edit], seen: dict[str, str]) -> Mark:
    first, last = edits[0], edits[-1]
    began_with = NOTHING if first.number == 1 else None
    since = seen.get(first.program_id) or first.parent_id or began_with
    seen[last.program_id] = last.version_id
    return replace(_mark(last, first.at, last.at), n_edits=len(edits), since=since)


def _run(run: Run) -> Mark:
    return replace(_mark(run, run.at, run.ended_at), run=run)


def _mark(of: Edit | Run, at: str, until: str | None) -> Mark:
    return Mark(
        at=at,
        until=until,
        program_id=of.program_id,
        program_name=of.program_name,
        version_id=of.version_id,
        computer_id=of.computer_id,
        number=of.number,
    )


def _with_repairs(marks: Iterable[Mark]) -> Iterator[Mark]:
    """The first good run of a program after a failing one, with the last that failed before it."""
    failing: dict[str, Run] = {}
    for mark in marks:
        run, program = mark.run, mark.program_id or ""
        if run is None:
            yield mark
        elif is_failing(run):
            failing[program] = run
            yield mark
        elif program in failing and is_repair(run, failing[program]):
            repaired = failing.pop(program)
            yield replace(mark, repairs=repaired.id, since=repaired.version_id)
        else:
            yield mark
