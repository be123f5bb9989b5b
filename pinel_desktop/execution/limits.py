"""Limits checked at run time; limits of the document are in `program/limits.py`."""

MAX_MEMORY = 10_000_000  # characters and items in all variables and parameters together
MAX_SAID = 1_000
MAX_MARKS = 1_000
MAX_BEEPS = 1_000
MAX_QUESTIONS = 1_000
