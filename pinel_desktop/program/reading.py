"""Reading a document: all of its faults, or the program."""

from dataclasses import dataclass

from pinel_desktop.program.faults import Fault


@dataclass(frozen=True, slots=True)
class Reading:
    """Outcome of reading a document: `document` is the normal form as plain JSON data, None with faults."""

    document: dict[str, object] | None
    faults: tuple[Fault, ...] = ()
    warnings: tuple[Fault, ...] = ()


def read_document(source: str | bytes | dict[str, object] | list[object]) -> Reading:
    """Reads a document given as JSON text or as parsed data; never raises for what it contains."""
    raise NotImplementedError
