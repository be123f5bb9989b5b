"""What a person should know about the file, and what came back of a damaged one."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Notice:
    """Something a person should know about the file that was opened."""

    code: str
    params: dict[str, object]


@dataclass(frozen=True, slots=True)
class SalvageResult:
    """What came out of a damaged file.

    Attributes:
        n_edits: versions of programs that came back.
        n_rows: rows of all tables that came back, or came back in a later state.
        n_unread: versions that are known to have been, and could not be read.
        is_cut_short: reading took too long and was ended.
    """

    n_edits: int = 0
    n_rows: int = 0
    n_unread: int = 0
    is_cut_short: bool = False
