"""SQL about runs whose pass does not count: not confirmed on this PC yet, or damaged since they were written.

`storage/exchange/confirmation_tracking.py` records unconfirmed runs, `storage/file/row_checksums.py` finds damage.
"""

from typing import Literal

ConfirmationFinding = Literal["differs", "not_passed", "not_repeatable"]
FINDINGS: tuple[ConfirmationFinding, ...] = ("differs", "not_passed", "not_repeatable")
WAITING = "waiting"


def counted(run: str = "runs") -> str:
    """Returns the SQL of a run's column `passed`, NULL while its pass does not count."""
    marked = f"{run}.id IN (SELECT run_id FROM unconfirmed_runs)"
    return f"CASE WHEN {marked} OR {_is_damaged(run)} THEN NULL ELSE {run}.passed END"


def confirmation_status(run: str = "runs") -> str:
    """Returns SQL that is NULL for a run that needs no confirmation, else `waiting` or the finding."""
    return f"(SELECT coalesce(finding, '{WAITING}') FROM unconfirmed_runs WHERE run_id = {run}.id)"


def masking_damage(column: str, run: str = "runs") -> str:
    """Returns the SQL of a run's column for lists: a damaged run has failed, with the reason `run_damaged`."""
    part = f"""(SELECT json_object('part', table_name) FROM content_sums
        WHERE row_id = {run}.id AND damaged_at IS NOT NULL LIMIT 1)"""
    instead = {"state": "'failed'", "reason": "'run_damaged'", "params": part}
    if column not in instead:
        return f"{run}.{column}"
    return f"CASE WHEN {_is_damaged(run)} THEN {instead[column]} ELSE {run}.{column} END"


def _is_damaged(run: str) -> str:
    return f"{run}.id IN (SELECT row_id FROM content_sums WHERE damaged_at IS NOT NULL)"
