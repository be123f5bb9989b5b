"""A program as Python text, and such a text as a program."""

from typing import Annotated, Any

from pydantic import Field

from pinel_desktop.web.models import Body, Json, Shape
from pinel_desktop.web.models.errors import Fault


class PythonLine(Shape):
    """What a line of the text stands for; lines count from 1."""

    line: int
    pointer: str
    block: str | None


class WrittenPython(Shape):
    """The text, null where the document has faults, and which command each line is."""

    text: str | None
    lines: list[PythonLine]
    faults: list[Fault]


class PythonSource(Body):
    """Python text as the page holds it."""

    text: Annotated[str, Field(max_length=2**20)]


class ReadPython(Shape):
    """The document, null where the text has faults; those tell `line` and `column` in `params`."""

    document: Json | None
    faults: list[Fault]


class DocumentToWrite(Body):
    """A program document, or a bare list of commands."""

    document: dict[str, Any] | list[Any]
