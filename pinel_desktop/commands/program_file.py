"""Reads a program from a file or from standard input, and prints its faults."""

import sys
from collections.abc import Mapping

from pinel_desktop.commands.printing import print_problem
from pinel_desktop.messages import describe
from pinel_desktop.program.faults import Fault
from pinel_desktop.program.limits import MAX_BYTES
from pinel_desktop.program.reading import ParseResult
from pinel_desktop.program.sources import read_source


def read_file(file: str) -> ParseResult:
    """Reads a document, a bare list or Python text; `-` is standard input. An unreadable file is a fault."""
    try:
        if file == "-":
            return read_source(sys.stdin.buffer.read(MAX_BYTES + 1))
        with open(file, "rb") as opened:
            return read_source(opened.read(MAX_BYTES + 1), file)
    except (OSError, ValueError):  # ValueError: a null byte in the name
        return ParseResult(None, (Fault("file_unreadable", params={"path": file}),))


def location_of(pointer: str, params: Mapping[str, object], language: str) -> str:
    """Returns the location of a fault as text: line and column, or the pointer in a document."""
    if {"line", "column"} <= params.keys():
        return describe("python_at", params, language).message
    return pointer or "/"


def print_faults(faults: tuple[Fault, ...], language: str) -> None:
    """Prints each fault on one line of standard error."""
    for fault in faults:
        print_problem(fault, language, place=location_of(fault.pointer, fault.params, language))
