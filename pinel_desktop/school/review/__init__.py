"""Review of a group's work: differences of two versions, events of a lesson. PURE: no IO, thread or clock."""

from pinel_desktop.school.review.advice import Advice, kept_advice
from pinel_desktop.school.review.blocks import BlocksInUse, blocks_in_use
from pinel_desktop.school.review.difference import (
    Change,
    ChangedBlock,
    Counts,
    Difference,
    difference,
)
from pinel_desktop.school.review.lesson import (
    Figures,
    GroupReview,
    LessonReview,
    review_group,
    review_lesson,
    versions_needed,
)
from pinel_desktop.school.review.marks import Mark
from pinel_desktop.school.review.records import Edit, GroupWork, Run
from pinel_desktop.school.review.spreadsheet import spreadsheet
from pinel_desktop.school.review.summary import Fault, Need, Summary, summary

__all__ = [
    "Advice",
    "BlocksInUse",
    "Change",
    "ChangedBlock",
    "Counts",
    "Difference",
    "Edit",
    "Fault",
    "Figures",
    "GroupReview",
    "GroupWork",
    "LessonReview",
    "Mark",
    "Need",
    "Run",
    "Summary",
    "blocks_in_use",
    "difference",
    "kept_advice",
    "review_group",
    "review_lesson",
    "spreadsheet",
    "summary",
    "versions_needed",
]
