"""Programs as Python text."""

from typing import Annotated, Any

from pydantic import Field

from pinel_desktop.web.models import Body, Json, Shape
from pinel_desktop.web.models.errors import Fault


class PythonLine(Shape):
    """The command that a line of the text belongs to; lines count from 1."""

    line: int
    pointer: str
    block: str | None


class WrittenPython(Shape):
    """The text with the command of each line; null if the document has faults."""

    text: str | None
    lines: list[PythonLine]
    faults: list[Fault]


class PythonSource(Body):
    """Python text of a program."""

    text: Annotated[str, Field(max_length=2**20)]


class ReadPython(Shape):
    """The document; null if the text has faults, which have `line` and `column` in `params`."""

    document: Json | None
    faults: list[Fault]


class DocumentToWrite(Body):
    """A program document, or a bare list of commands."""

    document: dict[str, Any] | list[Any]
