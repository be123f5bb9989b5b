"""Error responses, and faults of documents."""

from pinel_desktop.web.models import Json, ResponseModel


class Fault(ResponseModel):
    """One fault of a document: its position as a JSON pointer, the block there, and a message."""

    code: str
    pointer: str
    block: str | None
    message: str
    remedy: str
    params: Json


class Notice(ResponseModel):
    """A message for a person, its remedy, and what only a technician can do about it."""

    code: str
    message: str
    remedy: str
    details: str


class ErrorBody(ResponseModel):
    """An error; `faults` is empty unless a document has faults. `details` is for a technician, mostly empty."""

    code: str
    message: str
    remedy: str
    details: str
    params: Json
    faults: list[Fault]


class ErrorAnswer(ResponseModel):
    """Every response with a status of 400 and above."""

    error: ErrorBody
