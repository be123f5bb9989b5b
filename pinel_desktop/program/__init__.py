"""The program document (docs/program-document.md): model, reading, faults. PURE: no IO, thread or clock."""

from pinel_desktop.program.faults import Fault
from pinel_desktop.program.model import Program
from pinel_desktop.program.reading import Reading, read_document

__all__ = ["Fault", "Program", "Reading", "read_document"]
