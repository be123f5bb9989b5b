"""The store: one SQLite file with everything that groups made and ran.

A leaf: it imports nothing of the application. `open_store` opens the file, `open_for_reading` opens it without changing
it, `RunRecorder` records live runs.
"""

from storage.errors import StoreError
from storage.file.notices import Notice
from storage.recording import RunRecorder, warm_up
from storage.row_types import (
    CALIBRATED_ROBOT,
    SIMULATOR,
    CalibratedRobotRow,
    ClassroomRow,
    FaultRow,
    GroupRow,
    LessonRow,
    NoteRow,
    OwnActivityRow,
    ProgramRow,
    RunRow,
    RunStart,
    RunSummary,
    SignSamples,
    TruePoseRow,
    TruthRow,
    VersionRow,
    VersionSummary,
)
from storage.runs.history import HistoryEntry, RunFilter
from storage.store import Store, open_for_reading, open_store
from storage.work.lesson_history import GroupHistory, GroupSummary, LessonHistory, LessonRun

__all__ = [
    "CALIBRATED_ROBOT",
    "SIMULATOR",
    "CalibratedRobotRow",
    "ClassroomRow",
    "FaultRow",
    "GroupHistory",
    "GroupRow",
    "GroupSummary",
    "HistoryEntry",
    "LessonHistory",
    "LessonRow",
    "LessonRun",
    "NoteRow",
    "Notice",
    "OwnActivityRow",
    "ProgramRow",
    "RunFilter",
    "RunRecorder",
    "RunRow",
    "RunStart",
    "RunSummary",
    "SignSamples",
    "Store",
    "StoreError",
    "TruePoseRow",
    "TruthRow",
    "VersionRow",
    "VersionSummary",
    "open_for_reading",
    "open_store",
    "warm_up",
]
