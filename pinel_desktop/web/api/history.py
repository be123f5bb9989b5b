"""Runs of all groups, for the teacher."""

from datetime import UTC, date, datetime, time, timedelta

from flask import Response

from pinel_desktop.web.api import TEACHER, Resource, responses
from pinel_desktop.web.api.runs import run_model
from pinel_desktop.web.models.review import GroupHead, HistoryPage, HistoryRun, RunHistoryResponse
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import services
from pinel_desktop.web.teaching import require_teacher
from storage import HistoryEntry, RunFilter

api = Resource("history", "Runs of all groups.", __name__)

# years for which time zone data are reliable
_FIRST_YEAR, _LAST_YEAR = 1971, 2200


@api.get("/runs", responses=responses(RunHistoryResponse, *TEACHER))
def list_history(query: HistoryPage) -> Response:
    """Runs of all groups, newest first, a page at a time. For the teacher."""
    require_teacher()
    lines = services().store.history.page(_filter(query), before=query.before, limit=query.limit)
    after = lines[-1].run.id if len(lines) == query.limit else None
    return json_response(RunHistoryResponse(runs=[_model(line) for line in lines], next=after))


def _filter(query: HistoryPage) -> RunFilter:
    begin, end = _bounds(query.day) if query.day else (None, None)
    return RunFilter(
        classroom_id=query.classroom,
        group_id=query.group,
        activity=query.activity,
        world=query.world,
        lesson_ids=tuple(services().store.lessons.parts(query.lesson)) if query.lesson else None,
        started_from=begin,
        started_before=end,
        outcome=query.outcome,
    )


def _bounds(day: date) -> tuple[str, str]:
    """Start and end in UTC of a day in the time zone of this PC."""
    if not _FIRST_YEAR <= day.year <= _LAST_YEAR:
        # no run is that old or new; "~" sorts after every time of that day
        return day.isoformat(), f"{day.isoformat()}~"
    midnights = (datetime.combine(day + timedelta(days=more), time()) for more in (0, 1))
    begin, end = (f"{midnight.astimezone(UTC):%Y-%m-%dT%H:%M:%S}" for midnight in midnights)
    return begin, end


def _model(line: HistoryEntry) -> HistoryRun:
    group = None if line.group is None else GroupHead.of(line.group)
    return HistoryRun.of(run_model(line.run), group=group)
