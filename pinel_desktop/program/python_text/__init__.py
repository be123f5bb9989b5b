"""Conversion between documents and Python text (docs/python-text.md). PURE: no IO; a text is never executed."""

from pinel_desktop.program.python_text.reading import read_python
from pinel_desktop.program.python_text.writing import TextLine, write_python

__all__ = ["TextLine", "read_python", "write_python"]
