"""One file per block category: what each command does. Importing this package fills TABLE."""

from pinel_desktop.execution.primitives import flow, gestures, motion
from pinel_desktop.execution.primitives.base import TABLE, Body, Primitive

__all__ = ["TABLE", "Body", "Primitive", "flow", "gestures", "motion"]
