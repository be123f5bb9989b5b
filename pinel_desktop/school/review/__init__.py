"""Review of a group's work: differences of two versions, events of a lesson. PURE: no IO, thread or clock."""

from pinel_desktop.school.review.advice import advice_of_cases, advice_of_report
from pinel_desktop.school.review.blocks import BlocksInUse, blocks_in_use
from pinel_desktop.school.review.difference import Change, Counts, Difference, difference
from pinel_desktop.school.review.group_timeline import TimelineEntry
from pinel_desktop.school.review.lesson import (
    GroupReview,
    LessonReview,
    review_group,
    review_lesson,
    versions_needed,
)
from pinel_desktop.school.review.lesson_events import Edit, GroupWork, Run
from pinel_desktop.school.review.spreadsheet import spreadsheet
from pinel_desktop.school.review.status import GroupStatus, status_of
from pinel_desktop.school.review.summary import CommonMistake, Summary, summary

__all__ = [
    "BlocksInUse",
    "Change",
    "CommonMistake",
    "Counts",
    "Difference",
    "Edit",
    "GroupReview",
    "GroupStatus",
    "GroupWork",
    "LessonReview",
    "Run",
    "Summary",
    "TimelineEntry",
    "advice_of_cases",
    "advice_of_report",
    "blocks_in_use",
    "difference",
    "review_group",
    "review_lesson",
    "spreadsheet",
    "status_of",
    "summary",
    "versions_needed",
]
