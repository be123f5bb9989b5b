"""The program as Python text, both ways (docs/python-text.md). PURE: no IO; nothing in a text is ever executed."""

from pinel_desktop.program.python_text.reading import PythonReading, read_python
from pinel_desktop.program.python_text.writing import Line, PythonText, write_python

__all__ = ["Line", "PythonReading", "PythonText", "read_python", "write_python"]
