"""Notices to people about the file, and the result of a salvage."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Notice:
    """A message to a person about the file that was opened."""

    code: str
    params: dict[str, object]


@dataclass(frozen=True, slots=True)
class SalvageResult:
    """The result of salvaging a damaged file.

    Attributes:
        n_edits: recovered versions of programs.
        n_rows: recovered rows of all tables, new or in a newer state.
        n_unread: versions that existed and could not be read.
        is_cut_short: the time limit of reading was reached.
    """

    n_edits: int = 0
    n_rows: int = 0
    n_unread: int = 0
    is_cut_short: bool = False
