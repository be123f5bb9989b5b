"""Conversion between documents and Python text. The text is never executed."""

from flask import Response

from pinel_desktop.web.api import Resource, responses
from pinel_desktop.web.models.python import (
    DocumentToWrite,
    PythonLine,
    PythonSource,
    ReadPython,
    WrittenPython,
)
from pinel_desktop.web.responses import describe_faults, json_response
from pinel_desktop.web.services import read_document, services

api = Resource("python", "Programs as Python text.", __name__)


@api.post("/python", responses=responses(WrittenPython, "body_too_large"))
def write(body: DocumentToWrite) -> Response:
    """Converts a document to Python text."""
    # not needed at the app's start
    from pinel_desktop.program.python_text import write_python  # noqa: PLC0415

    parts = services()
    reading = read_document(body.document)
    if reading.document is None:
        faults = describe_faults(reading.faults, parts.settings.language)
        return json_response(WrittenPython(text=None, lines=[], faults=faults))
    written = write_python(reading.document)
    lines = [
        PythonLine(line=number, pointer=line.pointer, block=line.block)
        for number, line in sorted(written.lines.items())
    ]
    return json_response(WrittenPython(text=written.text, lines=lines, faults=[]))


@api.post("/python/read", responses=responses(ReadPython, "body_too_large"))
def read(body: PythonSource) -> Response:
    """Converts Python text to a document, or lists all its faults."""
    from pinel_desktop.program.python_text import read_python  # noqa: PLC0415 - see above

    language = services().settings.language
    reading = read_python(body.text)
    faults = describe_faults(reading.faults, language)
    return json_response(ReadPython(document=reading.document, faults=faults))
