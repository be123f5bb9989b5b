"""The store: one SQLite file with everything that groups made and ran.

A leaf: imports nothing of the application. `open_store` opens the file,
`open_for_reading` only looks at it, `Recorder` records live runs into it.
"""

from storage.errors import StoreError
from storage.file.notices import Notice
from storage.recording import Recorder, warm_up
from storage.records import (
    SIMULATOR,
    ClassroomRow,
    FaultRow,
    GroupRow,
    LessonRow,
    NoteRow,
    OwnActivityRow,
    ProgramRow,
    RunLine,
    RunRow,
    RunStart,
    SignSamples,
    VersionMark,
    VersionRow,
)
from storage.runs.history import HistoryLine, RunFilter
from storage.store import Store, open_for_reading, open_store
from storage.work.lesson_records import EditLine, GroupLine, GroupLines, LessonLines, LessonRun

__all__ = [
    "SIMULATOR",
    "ClassroomRow",
    "EditLine",
    "FaultRow",
    "GroupLine",
    "GroupLines",
    "GroupRow",
    "HistoryLine",
    "LessonLines",
    "LessonRow",
    "LessonRun",
    "NoteRow",
    "Notice",
    "OwnActivityRow",
    "ProgramRow",
    "Recorder",
    "RunFilter",
    "RunLine",
    "RunRow",
    "RunStart",
    "SignSamples",
    "Store",
    "StoreError",
    "VersionMark",
    "VersionRow",
    "open_for_reading",
    "open_store",
    "warm_up",
]
