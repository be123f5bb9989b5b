"""The store: one SQLite file with everything that groups made and ran.

A leaf: imports nothing of the application. `open_store` opens the file,
`open_for_reading` only looks at it, `Recorder` records live runs into it.
"""

from storage.errors import StoreError
from storage.history import HistoryLine, RunFilter
from storage.lessons_read import EditLine, GroupLine, GroupLines, LessonLines, LessonRun
from storage.opening import Notice
from storage.recording import Recorder, warm_up
from storage.records import (
    ClassroomRow,
    FaultRow,
    GroupRow,
    LessonRow,
    NoteRow,
    ProgramRow,
    RunLine,
    RunRow,
    RunStart,
    VersionMark,
    VersionRow,
)
from storage.store import Store, open_for_reading, open_store

__all__ = [
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
    "ProgramRow",
    "Recorder",
    "RunFilter",
    "RunLine",
    "RunRow",
    "RunStart",
    "Store",
    "StoreError",
    "VersionMark",
    "VersionRow",
    "open_for_reading",
    "open_store",
    "warm_up",
]
