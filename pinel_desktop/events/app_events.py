"""What the app itself tells all pages on the stream. None of it belongs to the record of a run."""

from dataclasses import dataclass
from typing import ClassVar

from pinel_desktop.events.model import StreamEvent


@dataclass(frozen=True, slots=True)
class Hello(StreamEvent):
    """The first event of the stream.

    Attributes:
        run: id of the live run; null when there is none.
    """

    type: ClassVar[str] = "hello"
    run: str | None


@dataclass(frozen=True, slots=True)
class Notice(StreamEvent):
    """Something that a person should know now, in words of the chosen language.

    A run goes on but is not being recorded (`disk_full`), and is recorded again (`recording_resumed`); the file is
    in danger (`disk_nearly_full`, `backup_failed`), and is no longer (`keeping_well_again`).

    Attributes:
        code: code of the message.
        message: what has happened.
        remedy: what to do.
    """

    type: ClassVar[str] = "notice"
    code: str
    message: str
    remedy: str


@dataclass(frozen=True, slots=True)
class Judged(StreamEvent):
    """A run that has ended was checked against the activity of its lesson.

    Attributes:
        run: id of the run.
        passed: whether it passed.
        missing: in words what does not hold yet; null where the program fulfils the activity, also when the run did
            not come to its end.
    """

    type: ClassVar[str] = "judged"
    run: str
    passed: bool
    missing: str | None


@dataclass(frozen=True, slots=True)
class ProgramChanged(StreamEvent):
    """A program was saved, deleted or restored; told to all windows that have it open.

    Attributes:
        program: id of the program.
        version: id of the version that was saved; null where the program went into the bin or came out of it.
        deleted_at: since when it lies in the bin; null where it does not.
    """

    type: ClassVar[str] = "program"
    program: str
    version: str | None
    deleted_at: str | None
