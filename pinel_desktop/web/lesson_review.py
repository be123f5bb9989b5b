"""Reads the review of a lesson from the store and converts it to responses."""

import contextlib
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe
from pinel_desktop.school.own_activities import all_titles, known_activity
from pinel_desktop.school.review import (
    BlocksInUse,
    Edit,
    GroupReview,
    GroupStatus,
    GroupWork,
    LessonReview,
    Run,
    Summary,
    TimelineEntry,
    advice_of_cases,
    review_group,
    review_lesson,
    summary,
    versions_needed,
)
from pinel_desktop.web.group_sentences import sentence_of
from pinel_desktop.web.models import review as shapes
from pinel_desktop.web.models.classes import Lesson
from pinel_desktop.web.services import Services
from pinel_desktop.web.timeline_table import timeline_csv
from storage import GroupHistory, GroupSummary, LessonHistory, LessonRow, LessonRun, Store
from storage.text import natural_key


@dataclass(frozen=True, slots=True)
class LessonReport:
    """A lesson with its review.

    Attributes:
        activity: of all parts of the lesson; None without one, or if they differ.
        missions: names of the activities of its parts.
        differing: titles of the activities of the parts if they differ.
        parts: titles of the lesson and of the lessons joined to it, by their key.
        reasons: messages why runs ended, by run id.
        advice_texts: diagnoses and check texts for runs that did not pass, by run id.
        not_started: names of the groups of the class without work in the lesson; empty if the lesson is over.
        titles: of activities, by name.
        hints: of activities with opened hints, by name.
    """

    lesson: LessonRow
    history: LessonHistory
    review: LessonReview
    activity: str | None
    missions: list[str]
    differing: list[str]
    parts: dict[str, str]
    reasons: dict[str, str]
    advice_texts: dict[str, str]
    not_started: list[str]
    titles: dict[str, str]
    hints: dict[str, list[str]]
    language: str

    def model(self, store: Store) -> shapes.LessonReview:
        """Returns the response for the page; the store has the programs that sentences name blocks of."""
        found = summary(self.review, self.activity)
        texts = self.reasons | self.advice_texts
        heads = {group.id: shapes.GroupHead.of(group) for group in self.history.groups}
        groups = [
            shapes.GroupReview(
                group=heads[group.id],
                need=found.needs[group.id],
                sentence=self._sentence(found.statuses[group.id], store, texts),
                entries=[self._entry(entry, texts) for entry in group.timeline],
                figures=shapes.Figures.of(group.metrics),
                blocks=_blocks(group.blocks),
                hints=[self._hints(name, n) for name, n in group.hints.items()],
            )
            for group in self.review.groups
        ]
        lesson = Lesson.of(self.lesson)
        return shapes.LessonReview(lesson=lesson, summary=self._summary(found), groups=groups)

    def _sentence(self, status: GroupStatus, store: Store, texts: dict[str, str]) -> str:
        other = self._other_mission(status.run)
        return sentence_of(status, store, texts=texts, other_mission=other, language=self.language)

    def _entry(self, entry: TimelineEntry, texts: dict[str, str]) -> shapes.TimelineEntry:
        return _timeline_entry(entry, self.history, texts, self._other_mission(entry.run))

    def _other_mission(self, run: Run | None) -> str | None:
        """Title of a run's activity if the lesson has activities, and others."""
        name = run and run.activity
        if not name or not self.missions or name in self.missions:
            return None
        return self.titles.get(name, name)

    def _hints(self, activity: str, n: int) -> shapes.OpenedHints:
        texts = self.hints.get(activity, [])[:n]
        return shapes.OpenedHints(title=self.titles.get(activity, activity), n=n, texts=texts)

    def _summary(self, found: Summary) -> shapes.LessonSummary:
        fault = found.mistake
        texts = self.advice_texts if fault and fault.is_advice else self.reasons
        return shapes.LessonSummary(
            n_groups=found.n_groups,
            n_passed=found.n_passed,
            stuck=list(found.stuck),
            fault=texts.get(fault.run) if fault else None,
            fault_run=fault.run if fault else None,
            n_with_fault=fault.n_groups if fault else 0,
            not_begun=self.not_started,
            differing=self.differing,
        )

    def table(self) -> str:
        """Returns the timelines as CSV text."""
        computers, titles = self.history.computers, self.titles
        return timeline_csv(self.review, computers, self.parts, self.reasons, titles, self.language)


def read_lesson(lesson_id: str, parts: Services) -> LessonReport:
    """Reads a lesson with all lessons joined to it. Reads the workspaces of one group at a time, to save memory.

    Raises:
        StoreError: `lesson_not_found`.
    """
    store, language = parts.store, parts.settings.language
    lesson = store.lessons.get(lesson_id)
    parts_of_it = [store.lessons.get(one) for one in store.lessons.parts(lesson_id)]
    lines = store.lesson_histories.of([one.id for one in parts_of_it])
    titles = all_titles(store, language)
    named = _activities(parts_of_it)
    activity = named[0] if len(named) == 1 else None
    groups: list[GroupReview] = []
    for group in lines.groups:
        work = _work(group, lines.work[group.id])
        workspaces = store.lesson_histories.workspaces(versions_needed(work))
        groups.append(review_group(work, workspaces, activity))
    return LessonReport(
        lesson=lesson,
        history=lines,
        review=review_lesson(groups),
        activity=activity,
        missions=named,
        differing=[titles.get(name, name) for name in named] if len(named) > 1 else [],
        parts={one.id: one.title for one in parts_of_it},
        reasons=_reasons(lines, language),
        advice_texts=_advice_texts(lines, language),
        not_started=_not_started(store, lesson, lines),
        titles=titles,
        hints=_hints({name for one in groups for name in one.hints}, parts),
        language=language,
    )


def _activities(lessons: list[LessonRow]) -> list[str]:
    """Returns the names of the activities of joined lessons, each once."""
    return list(dict.fromkeys(one.activity for one in lessons if one.activity))


def _work(group: GroupSummary, lines: GroupHistory) -> GroupWork:
    edits = tuple(
        Edit(**edit._asdict() | {"setup_only": bool(edit.setup_only)}) for edit in lines.edits
    )
    return GroupWork(group.id, group.name, edits, tuple(map(_run, lines.runs)))


def _run(run: LessonRun) -> Run:
    advice = advice_of_cases(run.advice_json)
    mistake_key = advice.mistake(run.activity or "") if advice else None
    names = Run.__dataclass_fields__.keys() - {"mistake_key"}
    return Run(**{name: getattr(run, name) for name in names}, mistake_key=mistake_key)


def _advice_texts(lines: LessonHistory, language: str) -> dict[str, str]:
    runs = (run for work in lines.work.values() for run in work.runs)
    advices = ((run.id, advice_of_cases(run.advice_json)) for run in runs)
    return {run_id: advice.of(language) for run_id, advice in advices if advice}


def _not_started(store: Store, lesson: LessonRow, lines: LessonHistory) -> list[str]:
    """Names of groups without work; empty after the lesson, because groups may have joined or left the class since."""
    now = store.lessons.current(lesson.classroom_id)
    if lesson.classroom_id is None or now is None or now.id != lesson.id:
        return []
    groups = (one for one in store.groups.all() if one.classroom_id == lesson.classroom_id)
    names = (one.name for one in groups if one.id not in lines.work)
    return sorted(names, key=natural_key)


def _hints(names: Iterable[str], parts: Services) -> dict[str, list[str]]:
    """Returns the hints of activities, by name; none for an activity that this release cannot use."""
    found: dict[str, list[str]] = {}
    for name in names:
        with contextlib.suppress(PinelError):
            hints = known_activity(parts.store, name).hints
            found[name] = [hint.of(parts.settings.language) for hint in hints]
    return found


def _reasons(lines: LessonHistory, language: str) -> dict[str, str]:
    runs = (run for work in lines.work.values() for run in work.runs)
    return {
        run.id: describe(run.reason, run.params, language).message for run in runs if run.reason
    }


def _timeline_entry(
    entry: TimelineEntry, lines: LessonHistory, texts: dict[str, str], other_mission: str | None
) -> shapes.TimelineEntry:
    run, changes = entry.run, entry.changes
    return shapes.TimelineEntry(
        kind="run" if run else "edit",
        at=entry.at,
        until=entry.until,
        computer=lines.computers.get(entry.computer_id or ""),
        program_id=entry.program_id,
        program_name=entry.program_name,
        version_id=entry.version_id,
        number=entry.number,
        n_edits=None if run else entry.n_edits,
        since=entry.since,
        changes=None if changes is None else shapes.ChangeCounts.of(changes),
        other_mission=other_mission,
        **_of_run(run, texts),
        repairs=entry.repairs,
    )


def _of_run(run: Run | None, texts: dict[str, str]) -> dict[str, Any]:
    names = ("state", "reason", "activity", "passed", "unconfirmed", "duration_s", "link")
    if run is None:
        return dict.fromkeys(("run_id", "message", *names))
    values = {name: getattr(run, name) for name in names}
    return {"run_id": run.id, "message": texts.get(run.id), **values}


def _blocks(use: BlocksInUse) -> list[shapes.BlockCount]:
    """Counts of block types in alphabetical order, because an order by count would be a ranking."""
    return [
        shapes.BlockCount(type=kind, count=use.attached.get(kind, 0), loose=use.loose.get(kind, 0))
        for kind in sorted({*use.attached, *use.loose})
    ]
