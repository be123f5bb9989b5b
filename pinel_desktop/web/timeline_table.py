"""The timelines of a lesson as a CSV table, with headings and values in the given language."""

from collections.abc import Mapping
from datetime import datetime

from pinel_desktop.messages import catalogue, describe
from pinel_desktop.messages.content import world_titles
from pinel_desktop.robot.robot_profile import ROOM
from pinel_desktop.school.review import Counts, LessonReview, TimelineEntry, spreadsheet
from pinel_desktop.school.review.spreadsheet import Cell

_COLUMNS = (
    "group",
    "computer",
    "at",
    "kind",
    "program",
    "version",
    "n_edits",
    "added",
    "removed",
    "changed",
    "moved",
    "state",
    "reason",
    "activity",
    "passed",
    "duration_s",
    "repairs",
    "robot",
    "lesson",
    "world",
)


def timeline_csv(
    review: LessonReview,
    computers: Mapping[str, str],
    lessons: Mapping[str, str],
    reasons: Mapping[str, str],
    titles: Mapping[str, str],
    language: str,
) -> str:
    """Returns CSV text with one row for each timeline entry of each group.

    Args:
        computers: names of PCs by their key.
        lessons: titles of the lesson and of the lessons joined to it, by their key.
        reasons: messages why runs ended, by run id.
        titles: of activities, by name.
    """

    own = describe("review_own_world", {}, language).message
    worlds = world_titles(language) | {
        "own": own,
        ROOM: describe("review_room", {}, language).message,
    }

    def text(code: str) -> str:
        return describe(f"review_{code}", {}, language).message

    def row(name: str, entry: TimelineEntry, begins: Mapping[str, str]) -> list[Cell]:
        run, changes = entry.run, entry.changes
        counts = changes or Counts()
        changed = (counts.added, counts.removed, counts.changed, counts.moved)
        return [
            name,
            computers.get(entry.computer_id or ""),
            _local(entry.at),
            text(f"kind_{entry.kind}"),
            entry.program_name,
            entry.number,
            None if run else entry.n_edits,
            *(None if changes is None else count for count in changed),
            text(f"state_{run.state}") if run else None,
            reasons.get(run.id) if run else None,
            titles.get(run.activity, run.activity) if run and run.activity else None,
            None if run is None or run.passed is None else text(_YES_NO[run.passed]),
            run.duration_s if run else None,
            begins.get(entry.repairs or ""),
            _robot(run.link, language) if run else None,
            lessons.get(entry.lesson_id or ""),
            worlds.get(run.world, run.world) if run and run.world else None,
        ]

    rows = [
        row(group.name, entry, {one.run.id: _local(one.at) for one in group.timeline if one.run})
        for group in review.groups
        for entry in group.timeline
    ]
    return spreadsheet([text(f"column_{name}") for name in _COLUMNS], rows, language)


_YES_NO = {True: "passed_yes", False: "passed_no"}


def _robot(link: str, language: str) -> str:
    """Returns the name of the robot's kind; the link itself if only a newer release knows it."""
    code = f"review_robot_{link}"
    return describe(code, {}, language).message if code in catalogue(language) else link


def _local(time: str) -> str:
    """Converts a time to the time zone of this PC, in a form that spreadsheets read; invalid text stays unchanged."""
    try:
        return f"{datetime.fromisoformat(time).astimezone():%Y-%m-%d %H:%M:%S}"
    except (ValueError, OverflowError):
        return time
