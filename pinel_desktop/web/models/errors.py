"""The one shape of every error, and faults of documents."""

from pinel_desktop.web.models import Json, Shape


class Fault(Shape):
    """One thing wrong with a document, with its place and its words."""

    code: str
    pointer: str
    block: str | None
    message: str
    remedy: str
    params: Json


class Notice(Shape):
    """Something a person should know, and what to do about it."""

    code: str
    message: str
    remedy: str


class ErrorBody(Shape):
    """What went wrong; `faults` is empty unless a document is at fault."""

    code: str
    message: str
    remedy: str
    params: Json
    faults: list[Fault]


class ErrorAnswer(Shape):
    """Every answer with a status of 400 and above."""

    error: ErrorBody
