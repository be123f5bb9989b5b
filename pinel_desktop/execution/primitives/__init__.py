"""One file per block category: what each command does. Importing this package fills TABLE."""

from pinel_desktop.execution.primitives import (
    drawing,
    flow,
    functions,
    gestures,
    motion,
    talking,
    variables,
)
from pinel_desktop.execution.primitives.base import TABLE, Primitive

__all__ = [
    "TABLE",
    "Primitive",
    "drawing",
    "flow",
    "functions",
    "gestures",
    "motion",
    "talking",
    "variables",
]
