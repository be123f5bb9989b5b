"""Limits checked at run time; limits of the document are in `program/limits.py`."""

from typing import NamedTuple

MAX_MEMORY = 10_000_000  # characters and items in all variables and parameters together
MAX_SHOWN_TEXTS = 1_000
MAX_MARKS = 1_000
MAX_BEEPS = 1_000
MAX_QUESTIONS = 1_000


class StepLimit(NamedTuple):
    """Limits of the steps of a run that nobody watches, so that an endless loop ends soon.

    Attributes:
        at_rest: steps without a motion between them.
        total: steps of the whole run.
    """

    at_rest: int
    total: int
