"""SQL about runs whose pass does not count until this PC has repeated them (`storage/exchange/trust.py` marks them)."""

from typing import Literal

Finding = Literal["differs", "not_passed", "not_repeatable"]
FINDINGS: tuple[Finding, ...] = ("differs", "not_passed", "not_repeatable")
WAITING = "waiting"


def counted(run: str = "runs") -> str:
    """The column `passed` of a run, NULL while its pass does not count."""
    marked = f"{run}.id IN (SELECT run_id FROM unconfirmed_runs)"
    return f"CASE WHEN {marked} THEN NULL ELSE {run}.passed END"


def mark(run: str = "runs") -> str:
    """NULL where a run needs no confirmation, else `waiting` or what was found."""
    return f"(SELECT coalesce(finding, '{WAITING}') FROM unconfirmed_runs WHERE run_id = {run}.id)"
