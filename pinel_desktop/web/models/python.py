"""Programs as Python text."""

from typing import Annotated, Any

from pydantic import Field

from pinel_desktop.web.models import Json, RequestModel, ResponseModel
from pinel_desktop.web.models.errors import Fault


class PythonLine(ResponseModel):
    """The command that a line of the text belongs to; lines count from 1."""

    line: int
    pointer: str
    block: str | None


class WrittenPython(ResponseModel):
    """The text with the command of each line; null if the document has faults."""

    text: str | None
    lines: list[PythonLine]
    faults: list[Fault]


class PythonSource(RequestModel):
    """Python text of a program."""

    text: Annotated[str, Field(max_length=2**20)]


class ReadPython(ResponseModel):
    """The document; null if the text has faults, which have `line` and `column` in `params`."""

    document: Json | None
    faults: list[Fault]


class DocumentToWrite(RequestModel):
    """A program document, or a bare list of commands."""

    document: dict[str, Any] | list[Any]
