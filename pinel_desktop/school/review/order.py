"""Orders the events of each PC.

Keys made on one PC grow with time unless its clock is set back; version numbers of a program always grow. Events are
ordered by key, except where the version numbers contradict the keys. Clocks of two PCs are never compared.
"""

from collections import defaultdict
from collections.abc import Iterable
from itertools import chain

from pinel_desktop.school.review.lesson_events import Edit, Event, GroupWork, Run, key_of

_Rank = tuple[str, int, bool, str]


def timelines_of(work: GroupWork) -> list[list[Event]]:
    """Returns the events of each PC in order; a PC follows the PCs whose versions were edited on it."""
    by_computer: dict[str, list[Event]] = defaultdict(list)
    events: list[Event] = [*work.edits, *work.runs]
    for event in events:
        by_computer[event.computer_id or ""].append(event)
    lines = sorted(map(_timeline, by_computer.values()), key=lambda line: key_of(line[0]))
    return _after_their_parents(lines)


def _timeline(events: list[Event]) -> list[Event]:
    by_program: dict[str, list[Event]] = defaultdict(list)
    for event in events:
        by_program[event.program_id or ""].append(event)
    ranked = chain.from_iterable(map(_ranked, by_program.values()))
    return [event for _, event in sorted(ranked, key=lambda pair: pair[0])]


def _ranked(events: list[Event]) -> list[tuple[_Rank, Event]]:
    """Returns the events of one program, each with its rank among all events of the PC."""
    found: list[tuple[_Rank, Event]] = []
    reached = latest = ""
    for event in sorted(events, key=_by_number):
        key = key_of(event)
        if isinstance(event, Edit):
            # if the clock was set back, the edit still follows all events of earlier versions
            reached = key if key > reached else latest
        rank = max(key, reached)
        latest = max(latest, rank)
        found.append(((rank, *_by_number(event)), event))
    return found


def _by_number(event: Event) -> tuple[int, bool, str]:
    return event.number or 0, isinstance(event, Run), key_of(event)


def _after_their_parents(lines: list[list[Event]]) -> list[list[Event]]:
    made_in = {key_of(event): index for index, line in enumerate(lines) for event in line}
    before = [_parent_timelines(line, made_in) - {index} for index, line in enumerate(lines)]
    ordered: list[int] = []
    while len(ordered) < len(lines):
        left = [index for index in range(len(lines)) if index not in ordered]
        free = [index for index in left if before[index].issubset(ordered)]
        ordered.append((free or left)[0])  # no order exists if two PCs edited each other's versions
    return [lines[index] for index in ordered]


def _parent_timelines(line: Iterable[Event], made_in: dict[str, int]) -> set[int]:
    parents = (event.parent_id for event in line if isinstance(event, Edit) and event.parent_id)
    return {made_in[parent] for parent in parents if parent in made_in}
